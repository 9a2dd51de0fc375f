#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/finding_limit.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

// A node that is quick gets SYNCs in quick succession; a finding rests on those of kPeriod and kPatience.
constexpr canopen::Duration kPeriod = std::chrono::milliseconds{20}, kPatience = std::chrono::milliseconds{250};

/// The TPDO of a check, with transmission type @p type.
std::optional<Pdo> synchronous(Context& context, std::uint8_t type) {
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo || !set_up(context, *pdo, {.type = type, .inhibit_time = 0, .event_timer = 0})) return std::nullopt;
  return pdo;
}

/// Goes to Operational; a step begins.
void start(Context& context) {
  context.enter(canopen::NmtState::Operational);
  context.session().pass(kPeriod);
  context.step();
}

/// The same from Pre-operational, once a slow node has entered it and has sent what it may still send: it is
/// looked at once more.
void start_again(Context& context) {
  context.enter(canopen::NmtState::PreOperational);
  context.session().pass(kPatience);
  start(context);
}

/// The same as synchronous(), in Operational; a step begins.
std::optional<Pdo> started(Context& context, std::uint8_t type) {
  std::optional<Pdo> pdo = synchronous(context, type);
  if (pdo) start(context);
  return pdo;
}

void comes_with_every_sync(Context& context) {
  constexpr int kSyncs = 10;
  const auto pdo = started(context, 1);
  if (!pdo) return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  SyncSource sync{context};
  const auto is_right = [](const std::vector<std::size_t>& counts) {
    return std::ranges::all_of(counts, [](std::size_t count) { return count == 1; });
  };
  std::vector<std::size_t> counts = sync.count_each(kSyncs, context.quiet(kPeriod), identifier, kPatience);
  if (!is_right(counts)) {
    start_again(context);
    counts = sync.count_each(kSyncs, kPeriod, identifier, kPatience);
  }
  if (!is_right(counts))
    context.fail(pdo->parameters(), kTypeSub, fmt::format("a frame of {}, type 1, after each SYNC", pdo->name()),
                 fmt::format("{} frames after {} SYNCs", fmt::join(counts, ", "), kSyncs));
}

/// True if one of three SYNCs brings a frame; which one is the first is the node's affair.
bool is_every_third(const std::vector<std::size_t>& counts) {
  constexpr std::ptrdiff_t kThree = 3;
  for (auto first = counts.begin(); counts.end() - first >= kThree; ++first)
    if (std::accumulate(first, first + kThree, std::size_t{0}) != 1) return false;
  return true;
}

void comes_with_every_nth_sync(Context& context) {
  constexpr std::uint8_t kType = 3;
  constexpr int kSyncs = 4 * kType;
  const auto pdo = started(context, kType);
  if (!pdo) return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  SyncSource sync{context};
  std::vector<std::size_t> counts = sync.count_each(kSyncs, context.quiet(kPeriod), identifier);
  if (!is_every_third(counts)) {
    start_again(context);
    counts = sync.count_each(kSyncs, 2 * kPeriod, identifier);
  }
  if (!is_every_third(counts))
    context.fail(pdo->parameters(), kTypeSub,
                 fmt::format("a frame of {}, type 3, with every third SYNC", pdo->name()),
                 fmt::format("{} frames after {} SYNCs", fmt::join(counts, ", "), counts.size()));
}

void is_silent_without_sync(Context& context) {
  const auto pdo = synchronous(context, 1);
  if (!pdo) return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  context.step();
  context.enter(canopen::NmtState::Operational);
  const auto frames = context.session().collect(under(identifier), std::chrono::milliseconds{200});
  if (!frames.empty())
    context.fail(pdo->parameters(), kTypeSub, fmt::format("no frame of {}, type 1, without SYNC", pdo->name()),
                 fmt::format("{} in 200 ms", frames.size()));
}

/// CiA's own test wants a frame with each SYNC here; CiA 301 wants an event between.
void type_0_waits_for_an_event(Context& context) {
  const auto object = changeable(context);
  const auto pdo = object ? test_pdo(context, PdoDirection::Transmit) : std::nullopt;
  if (!pdo || !set_up(context, *pdo, {.type = 0, .inhibit_time = 0, .event_timer = 0, .mapping = {*object}}))
    return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  SyncSource sync{context};
  context.enter(canopen::NmtState::Operational);
  (void)sync.run(1, kPeriod, identifier);  // entering Operational may be an event
  context.step();
  const std::size_t before = sync.run(4, kPeriod, identifier).size();
  const std::size_t mark = context.session().mark();
  (void)change(context, *object);
  const std::size_t early = frames_since(context, mark, identifier).size();
  const std::vector<std::size_t> after = sync.count_each(3, kPeriod, identifier);
  const auto fail = [&](std::string expected, std::string found) {
    context.fail(pdo->parameters(), kTypeSub, std::move(expected), std::move(found));
  };
  if (before != 0) fail("no frame of type 0 without an event", fmt::format("{} with 4 SYNCs", before));
  if (early != 0) fail("no frame of type 0 before the SYNC after an event", fmt::format("{}", early));
  if (after == std::vector<std::size_t>{0, 0, 0})
    context.note("a change of the mapped object is no event");
  else if (before == 0 && after != std::vector<std::size_t>{1, 0, 0})
    fail("one frame of type 0 with the SYNC after an event",
         fmt::format("{} with three SYNCs", fmt::join(after, ", ")));
}

void begins_with_the_start_value(Context& context) {
  constexpr std::uint8_t kStart = 3;
  if (!context.need(object::kSyncOverflow)) return;
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo) return;
  if (!has_parameter(context, *pdo, kSyncStartSub))
    return context.skip(fmt::format("object {} is not there", to_text(Subject{pdo->parameters(), kSyncStartSub})));
  if (!set_up(context, *pdo, {.type = 1, .inhibit_time = 0, .event_timer = 0, .sync_start = kStart})) return;
  if (const SdoAnswer answer = context.write_number(object::kSyncOverflow, 0, 10); !answer.done())
    return context.skip("1019h cannot be set: " + to_text(answer));
  const std::uint32_t identifier = identifier_of(context, *pdo);
  const std::vector<std::size_t> expected{0, 0, 1, 1, 1};
  start(context);
  std::vector<std::size_t> counts = SyncSource{context}.count_each(5, context.quiet(kPeriod), identifier);
  if (counts != expected) {
    start_again(context);
    counts = SyncSource{context}.count_each(5, kPeriod, identifier, kPatience);
  }
  if (counts != expected)
    context.fail(pdo->parameters(), kSyncStartSub, "the first frame with the SYNC of counter 3",
                 fmt::format("{} frames with counters 1 to 5", fmt::join(counts, ", ")));
}

/// Every valid TPDO whose type can be 1, so set.
std::vector<Pdo> all_with_type_1(Context& context) {
  std::vector<Pdo> pdos;
  for (const Pdo& pdo : all_pdos(context, PdoDirection::Transmit)) {
    const SdoAnswer cob_id = context.read(pdo.parameters(), kCobIdSub);
    if (!cob_id.done() || (cob_id.number() & kInvalid) != 0 || mapping_of(context, pdo).empty()) continue;
    if (set_up(context, pdo, {.type = 1, .inhibit_time = 0, .event_timer = 0})) pdos.push_back(pdo);
  }
  if (!pdos.empty()) context.unskip();
  return pdos;
}

/// Sends @p count SYNCs, each when the frames of all @p identifiers have come with the one before, or should have:
/// how many came under each in all.
std::vector<std::size_t> count_with_syncs(Context& context, const std::vector<std::uint32_t>& identifiers,
                                          std::size_t count) {
  Session& session = context.session();
  SyncSource sync{context};
  start(context);
  const std::size_t mark = session.mark();
  for (std::size_t i = 0; i < count; ++i) {
    const canopen::TimePoint next = session.now() + context.quiet(kPeriod);
    std::set<std::uint32_t> missing{identifiers.begin(), identifiers.end()};
    sync.send();
    (void)session.wait_for(
        [&](const canopen::Frame& frame) {
          if (!frame.remote && !frame.extended) missing.erase(frame.id);
          return missing.empty();
        },
        2 * kPeriod);
    session.pass(next - session.now());
  }
  const auto found = [&](std::uint32_t identifier) { return frames_since(context, mark, identifier).size(); };
  if (std::ranges::any_of(identifiers, [&](std::uint32_t each) { return found(each) < count; }))
    session.pass(kPatience);  // the last ones may be under way
  std::vector<std::size_t> counts;
  std::ranges::transform(identifiers, std::back_inserter(counts), found);
  return counts;
}

void all_come_with_every_sync(Context& context) {
  constexpr std::size_t kSyncs = 10;
  const std::vector<Pdo> pdos = all_with_type_1(context);
  if (pdos.empty()) {
    if (!context.skipped()) context.skip("no TPDO is valid");
    return;
  }
  std::vector<std::uint32_t> identifiers;
  for (const Pdo& pdo : pdos) identifiers.push_back(identifier_of(context, pdo));
  const std::vector<std::size_t> counts = count_with_syncs(context, identifiers, kSyncs);
  FindingLimit findings{context};
  for (std::size_t i = 0; i < pdos.size(); ++i)
    if (counts[i] != kSyncs)
      findings.fail({pdos[i].parameters(), kTypeSub},
                    fmt::format("{} frames of {} beside the {} others with {} SYNCs", kSyncs, pdos[i].name(),
                                pdos.size() - 1, kSyncs),
                    fmt::format("{}", counts[i]));
}

void misses_no_sync(Context& context) {
  constexpr std::size_t kSyncs = 250;
  constexpr canopen::Duration kFast = std::chrono::milliseconds{4}, kFaster = std::chrono::milliseconds{2};
  const auto pdo = started(context, 1);
  if (!pdo) return;
  const std::uint32_t identifier = identifier_of(context, *pdo);
  SyncSource sync{context};
  const auto count = [&](canopen::Duration period) {
    std::size_t found = sync.run(static_cast<int>(kSyncs), period, identifier).size();
    if (found < kSyncs)  // the last ones may be under way
      found += context.session().collect_first(kSyncs - found, under(identifier), kPatience).size();
    return found + context.session().collect(under(identifier), context.quiet(kPatience)).size();
  };
  const bool quick = context.quiet(kPeriod) < kPeriod;
  std::size_t frames = count(quick ? kFaster : kFast);
  if (frames != kSyncs && quick) {
    start_again(context);
    frames = count(kFast);
  }
  if (frames != kSyncs)
    context.fail(pdo->parameters(), kTypeSub,
                 fmt::format("{} frames of {} with {} SYNCs 4 ms apart", kSyncs, pdo->name(), kSyncs),
                 fmt::format("{}", frames));
}

constexpr std::array kChecks{
    Check{.id = "pdo.every-sync",
          .name = "A TPDO of type 1 is sent once with every SYNC",
          .clause = "CiA 301 7.2.2.2",
          .group = Group::Pdo,
          .run = comes_with_every_sync},
    Check{.id = "pdo.every-nth-sync",
          .name = "A TPDO of type 3 is sent once with every third SYNC",
          .clause = "CiA 301 7.2.2.2",
          .group = Group::Pdo,
          .run = comes_with_every_nth_sync},
    Check{.id = "pdo.no-sync",
          .name = "A TPDO of type 1 is not sent without SYNC",
          .clause = "CiA 301 7.2.2.2",
          .group = Group::Pdo,
          .run = is_silent_without_sync},
    Check{.id = "pdo.acyclic",
          .name = "A TPDO of type 0 is sent with the SYNC after an event, and only then",
          .clause = "CiA 301 7.2.2.2",
          .group = Group::Pdo,
          .run = type_0_waits_for_an_event},
    Check{.id = "pdo.sync-start-value",
          .name = "The SYNC whose counter is the start value is the first of a synchronous TPDO",
          .clause = "CiA 301 7.5.2.37",
          .group = Group::Pdo,
          .run = begins_with_the_start_value},
    Check{.id = "pdo.all-with-sync",
          .name = "All synchronous TPDOs are sent with every SYNC",
          .clause = "CiA 301 7.2.2.2",
          .group = Group::Pdo,
          .run = all_come_with_every_sync},
    Check{.id = "pdo.sync-count",
          .name = "Over 250 SYNCs no frame of a TPDO of type 1 is missing or double",
          .clause = "CiA 301 7.2.2.2",
          .group = Group::Pdo,
          .run = misses_no_sync},
};

}  // namespace

std::span<const Check> pdo_sync_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
