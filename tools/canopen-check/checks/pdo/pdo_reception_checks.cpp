#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

namespace conformance {
namespace {

using std::chrono::milliseconds;

/// How long a frame, or Start, may take to be processed, and how often a value is looked at meanwhile.
constexpr milliseconds kProcessed{50}, kSample{10};
/// How long Start takes of a node that was seen to take an RPDO directly behind it.
constexpr milliseconds kStarted{20};

/// The RPDO of a check, which carries one object.
struct Reception {
  Pdo pdo{};
  MappedObject object{};
  std::uint32_t identifier = 0;
  std::uint64_t before = 0;  ///< value of the object
};

/// Maps an object into an RPDO of @p type and goes to Operational; else the check is skipped.
std::optional<Reception> receive(Context& context, std::uint8_t type, std::uint16_t deadline = 0) {
  const auto pdo = test_pdo(context, PdoDirection::Receive);
  if (!pdo) return std::nullopt;
  const std::vector<MappedObject> objects = receivable(context);
  if (objects.empty()) {
    context.skip("the EDS has no object of the manufacturer that an RPDO can carry and an SDO can read");
    return std::nullopt;
  }
  const MappedObject object = objects.front();
  if (!set_up(context, *pdo, {.type = type, .event_timer = deadline, .mapping = {object}})) return std::nullopt;
  context.undo().keep(object.index, object.sub_index);
  Reception reception{*pdo, object, identifier_of(context, *pdo), 0};
  context.enter(canopen::NmtState::Operational);
  context.session().pass(context.manners().at_work.takes_rpdo_at_once ? kStarted : kProcessed);
  reception.before = context.read(object.index, object.sub_index).number();
  return reception;
}

/// Sends @p value in a frame @p extra bytes longer than the mapping.
void send(Context& context, const Reception& reception, std::uint64_t value, int extra = 0) {
  canopen::Frame frame{.id = reception.identifier,
                       .length = static_cast<std::uint8_t>(static_cast<int>(reception.object.bytes()) + extra)};
  for (std::size_t i = 0; i < reception.object.bytes(); ++i)
    frame.data[i] = static_cast<std::uint8_t>(value >> 8U * i);
  context.session().send(frame);
}

/// Gives the object its former value at the end of a check.
class GiveBack {
 public:
  GiveBack(Context& context, const Reception& reception) : context_{&context}, reception_{&reception} {}
  GiveBack(const GiveBack&) = delete;
  GiveBack& operator=(const GiveBack&) = delete;
  ~GiveBack() {
    send(*context_, *reception_, reception_->before);
    SyncSource{*context_}.send();
    context_->session().pass(milliseconds{20});
  }

 private:
  Context* context_;
  const Reception* reception_;
};

/// True once the object holds @p value, within 200 ms.
bool takes(Context& context, const Reception& reception, std::uint64_t value) {
  constexpr int kAttempts = 20;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const SdoAnswer now = context.read(reception.object.index, reception.object.sub_index);
    if (now.done() && now.number() == value) return true;
    context.session().pass(milliseconds{10});
  }
  return false;
}

std::string held(Context& context, const Reception& reception) {
  return fmt::format("{} holds {:X}h", to_text(Subject{reception.object.index, reception.object.sub_index}),
                     context.read(reception.object.index, reception.object.sub_index).number());
}

void takes_event_driven_values(Context& context) {
  const auto reception = receive(context, 255);
  if (!reception) return;
  const GiveBack give_back{context, *reception};
  const std::uint64_t value = other_value(context, reception->object);
  context.step();
  send(context, *reception, value);
  if (!takes(context, *reception, value))
    context.fail(reception->pdo.parameters(), kTypeSub,
                 fmt::format("{:X}h of {} taken at once", value, reception->pdo.name()),
                 held(context, *reception));
}

void takes_synchronous_values_with_sync(Context& context) {
  const auto reception = receive(context, 1);
  if (!reception) return;
  const GiveBack give_back{context, *reception};
  SyncSource sync{context};
  const std::uint64_t value = other_value(context, reception->object);
  context.step();
  send(context, *reception, value);
  context.session().pass(kProcessed);
  const SdoAnswer early = context.read(reception->object.index, reception->object.sub_index);
  if (early.done() && early.number() == value)
    return context.fail(reception->pdo.parameters(), kTypeSub,
                        fmt::format("{:X}h of {} waits for the SYNC", value, reception->pdo.name()),
                        "it was taken at once");
  sync.send();
  if (!takes(context, *reception, value))
    context.fail(reception->pdo.parameters(), kTypeSub,
                 fmt::format("{:X}h of {} taken with the SYNC", value, reception->pdo.name()),
                 held(context, *reception));
}

void ignores_short_frames(Context& context) {
  const auto reception = receive(context, 255);
  if (!reception) return;
  const GiveBack give_back{context, *reception};
  const std::uint64_t value = other_value(context, reception->object);
  context.step();
  send(context, *reception, value, -1);
  context.session().pass(kProcessed);
  const SdoAnswer now = context.read(reception->object.index, reception->object.sub_index);
  if (now.done() && now.number() != reception->before)
    context.fail(reception->pdo.mapping(), 0,
                 fmt::format("a frame shorter than {} is not processed", reception->pdo.name()),
                 held(context, *reception));
}

void takes_the_first_bytes_of_long_frames(Context& context) {
  const auto reception = receive(context, 255);
  if (!reception) return;
  const GiveBack give_back{context, *reception};
  const std::uint64_t value = other_value(context, reception->object);
  context.step();
  const std::size_t mark = context.session().mark();
  send(context, *reception, value, 1);
  const canopen::TimePoint until = context.session().now() + kProcessed;
  bool told = false, is_over = false;
  while (!is_over) {
    is_over = context.session().now() >= until;
    const std::uint64_t now = context.read(reception->object.index, reception->object.sub_index).number();
    told = !frames_since(context, mark, context.session().identifier(0x80)).empty();
    if (now == value || (told && now == reception->before)) return;
    context.session().pass(kSample);
  }
  context.fail(
      reception->pdo.mapping(), 0,
      fmt::format("the first bytes of a longer frame, {:X}h, are taken, or it is reported", value),
      fmt::format("{}, {}", held(context, *reception), told ? "an emergency message" : "no emergency message"));
}

/// The error code of the first emergency message of @p span that is not 0000h; of @p wanted, wherever it comes, if
/// that is given.
std::optional<std::uint32_t> emergency(Context& context, canopen::Duration span,
                                       std::optional<std::uint32_t> wanted = {}) {
  std::optional<std::uint32_t> first;
  (void)context.session().wait_for(
      [&, id = context.session().identifier(0x80)](const canopen::Frame& each) {
        const auto code = static_cast<std::uint32_t>(number_in(each) & 0xFFFFU);
        if (each.id != id || each.remote || each.length != 8 || code == 0) return false;
        if (!first || code == wanted) first = code;
        return !wanted || code == wanted;
      },
      span);
  return first;
}

void tells_of_a_missed_deadline(Context& context) {
  constexpr std::uint16_t kDeadline = 100;
  constexpr std::uint32_t kMissed = 0x8250;
  const auto pdo = test_pdo(context, PdoDirection::Receive);
  if (!pdo) return;
  if (!has_parameter(context, *pdo, kTimerSub))
    return context.skip(fmt::format("object {} is not there", to_text(Subject{pdo->parameters(), kTimerSub})));
  const auto reception = receive(context, 255, kDeadline);
  if (!reception) return;
  const GiveBack give_back{context, *reception};
  send(context, *reception, reception->before, -1);
  if (!emergency(context, milliseconds{100}))
    return context.skip("the node sends no emergency message, not even for a short RPDO");
  context.step();
  send(context, *reception, reception->before);
  const auto code = emergency(context, milliseconds{4 * kDeadline}, kMissed);
  if (code != kMissed)
    context.fail(reception->pdo.parameters(), kTimerSub, "emergency message 8250h for a missed event timer",
                 code ? fmt::format("{:04X}h", *code) : "none");
}

constexpr std::array kChecks{
    Check{.id = "pdo.rpdo-event-driven",
          .name = "Values of an event-driven RPDO take effect at once",
          .clause = "CiA 301 7.2.2.4",
          .group = Group::Pdo,
          .run = takes_event_driven_values},
    Check{.id = "pdo.rpdo-synchronous",
          .name = "Values of a synchronous RPDO take effect with the next SYNC",
          .clause = "CiA 301 7.2.2.2",
          .group = Group::Pdo,
          .run = takes_synchronous_values_with_sync},
    Check{.id = "pdo.rpdo-too-short",
          .name = "A frame shorter than the mapping of its RPDO is not processed",
          .clause = "CiA 301 7.2.2.5.2",
          .group = Group::Pdo,
          .run = ignores_short_frames},
    Check{.id = "pdo.rpdo-too-long",
          .name = "Of a frame longer than the mapping of its RPDO the first bytes are taken, or it is reported",
          .clause = "CiA 301 7.2.2.5.2",
          .group = Group::Pdo,
          .run = takes_the_first_bytes_of_long_frames},
    Check{.id = "pdo.rpdo-deadline",
          .name = "An RPDO that misses its event timer is reported with 8250h",
          .clause = "CiA 301 7.5.2.35",
          .group = Group::Pdo,
          .run = tells_of_a_missed_deadline},
};

}  // namespace

std::span<const Check> pdo_reception_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
