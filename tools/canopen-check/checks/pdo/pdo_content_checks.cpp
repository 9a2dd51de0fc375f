#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/finding_limit.hpp"

namespace conformance {
namespace {

constexpr std::size_t kMostBits = 64, kMostPdos = 8;
constexpr std::uint16_t kLastDummy = 7;

/// What is wrong with @p object in a mapping of @p pdo, by the EDS; nothing if it may be there.
std::optional<std::string> objection(Context& context, const Pdo& pdo, const MappedObject& object) {
  const Subject subject{object.index, object.sub_index};
  if (object.index <= kLastDummy) {
    const bool allowed = (unsigned{context.eds().device().dummy_types} >> object.index & 1U) != 0;
    if (allowed && pdo.direction == PdoDirection::Receive) return std::nullopt;
    return fmt::format("the dummy object {:04X}h", object.index);
  }
  const eds::EntryFacts* const facts = context.eds().find(object.index, object.sub_index);
  if (facts == nullptr) return fmt::format("{}, which is not in the EDS", to_text(subject));
  if (!facts->mappable) return fmt::format("{}, which is not mappable", to_text(subject));
  const canopen::Access forbidden =
      pdo.direction == PdoDirection::Receive ? canopen::Access::ReadWriteRead : canopen::Access::ReadWriteWrite;
  const bool direction = facts->access != forbidden &&
                         (pdo.direction == PdoDirection::Receive ? facts->writable() : facts->readable());
  if (!direction) return fmt::format("{}, which goes the other way", to_text(subject));
  if (facts->numeric() && facts->type->bits != object.bits)
    return fmt::format("{} with {} bits", to_text(subject), object.bits);
  return std::nullopt;
}

void maps_what_can_be_mapped(Context& context) {
  if (context.eds().empty()) return context.skip("without an EDS it is not known what can be mapped");
  FindingLimit findings{context};
  bool any = false;
  for (const PdoDirection direction : {PdoDirection::Receive, PdoDirection::Transmit})
    for (const Pdo& pdo : all_pdos(context, direction)) {
      any = true;
      context.step();
      std::size_t bits = 0;
      std::uint8_t sub = 0;
      for (const MappedObject& object : mapping_of(context, pdo)) {
        bits += object.bits;
        ++sub;
        if (const auto wrong = objection(context, pdo, object))
          findings.fail({pdo.mapping(), sub}, "an object that " + pdo.name() + " can carry", *wrong);
      }
      if (bits > kMostBits)
        findings.fail({pdo.mapping(), std::uint8_t{0}}, "at most 64 bits", fmt::format("{}", bits));
    }
  if (!any) context.skip("the node has no PDO");
}

/// What SDO reads say of mapped objects.
std::vector<SdoAnswer> read_all(Context& context, const std::vector<MappedObject>& objects) {
  std::vector<SdoAnswer> answers;
  answers.reserve(objects.size());
  for (const MappedObject& object : objects) answers.push_back(context.read(object.index, object.sub_index));
  return answers;
}

/// Sub-index of the first mapped object whose value in @p frame is none that SDO reads gave before and after;
/// 0 if all are right, or change too fast.
std::uint8_t first_difference(const canopen::Frame& frame, const std::vector<MappedObject>& objects,
                              const std::vector<SdoAnswer>& before, const std::vector<SdoAnswer>& after) {
  const std::uint64_t bits = number_in(frame);
  std::size_t at = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::size_t size = objects[i].bits;
    if (at + size > kMostBits) break;
    const std::uint64_t mask = size >= kMostBits ? ~std::uint64_t{0} : (std::uint64_t{1} << size) - 1;
    const bool steady = before[i].done() && after[i].done() && before[i].data == after[i].data;
    if (steady && (bits >> at & mask) != (before[i].number() & mask)) return static_cast<std::uint8_t>(i + 1);
    at += size;
  }
  return 0;
}

/// Compares frames of @p pdo, of type 1 and in Operational, with SDO reads of @p objects.
void compare(Context& context, FindingLimit& findings, const Pdo& pdo, const std::vector<MappedObject>& objects) {
  constexpr int kAttempts = 3;
  std::size_t length = 0;
  for (const MappedObject& object : objects) length += object.bits;
  length = (length + 7) / 8;
  const std::uint32_t identifier = identifier_of(context, pdo);
  SyncSource sync{context};
  std::uint8_t different = 0;
  std::optional<canopen::Frame> last;
  context.step();
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const std::vector<SdoAnswer> before = read_all(context, objects);
    const auto frame = sync.next(identifier, std::chrono::milliseconds{20});
    if (!frame) return;  // others check that it comes
    last = frame->frame;
    if (last->length != length)
      return findings.fail({pdo.mapping(), std::uint8_t{0}}, fmt::format("{} of {} bytes", pdo.name(), length),
                           fmt::format("{} bytes", last->length));
    different = first_difference(*last, objects, before, read_all(context, objects));
    if (different == 0) return;
  }
  const MappedObject& object = objects[different - 1U];
  findings.fail({pdo.mapping(), different},
                fmt::format("{} holds what an upload of {} gives, {}", pdo.name(),
                            to_text(Subject{object.index, object.sub_index}),
                            hexadecimal(context.read(object.index, object.sub_index).data)),
                hexadecimal(std::span{last->data}.first(length)));
}

void holds_what_uploads_give(Context& context) {
  FindingLimit findings{context};
  std::size_t compared = 0;
  for (const Pdo& pdo : all_pdos(context, PdoDirection::Transmit)) {
    const SdoAnswer cob_id = context.read(pdo.parameters(), kCobIdSub);
    const std::vector<MappedObject> objects = mapping_of(context, pdo);
    if (!cob_id.done() || (cob_id.number() & kInvalid) != 0 || objects.empty()) continue;
    if (compared == kMostPdos) break;
    context.enter(canopen::NmtState::PreOperational);
    if (!set_up(context, pdo, {.type = 1, .inhibit_time = 0, .event_timer = 0})) continue;
    ++compared;
    context.enter(canopen::NmtState::Operational);
    compare(context, findings, pdo, objects);
  }
  if (compared != 0) return context.unskip();
  if (!context.skipped()) context.skip("no TPDO is valid");
}

void takes_a_new_mapping(Context& context) {
  const auto pdo = test_pdo(context, PdoDirection::Transmit);
  if (!pdo) return;
  std::vector<MappedObject> objects = transmittable(context);
  if (objects.size() < 2) return context.skip("fewer than two objects are known that a TPDO can carry");
  objects = {objects[1], objects[0]};
  if (!disable(context, *pdo)) return;
  if (!context.write_number(pdo->mapping(), 0, 0).done()) return context.skip("the mapping is fixed");
  context.step();
  if (const SdoAnswer answer = map_objects(context, *pdo, objects); !answer.done())
    return context.fail(
        {pdo->mapping(), {}},
        fmt::format("{} and {} can be mapped", to_text(Subject{objects[0].index, objects[0].sub_index}),
                    to_text(Subject{objects[1].index, objects[1].sub_index})),
        to_text(answer));
  if (!set_up(context, *pdo, {.type = 1, .inhibit_time = 0, .event_timer = 0})) return;
  if (mapping_of(context, *pdo).size() != objects.size())
    return context.fail(pdo->mapping(), 0, "two mapped objects, as written",
                        fmt::format("{}", mapping_of(context, *pdo).size()));
  context.enter(canopen::NmtState::Operational);
  FindingLimit findings{context};
  compare(context, findings, *pdo, objects);
}

constexpr std::array kChecks{
    Check{.id = "pdo.mapping-objects",
          .name = "PDOs map objects that exist, may be mapped that way and fit into 64 bits",
          .clause = "CiA 301 7.5.2.36, 7.5.2.38",
          .group = Group::Pdo,
          .mode = Mode::ReadOnly,
          .run = maps_what_can_be_mapped},
    Check{.id = "pdo.content",
          .name = "TPDOs hold the values that uploads of the mapped objects give",
          .clause = "CiA 301 7.5.2.38",
          .group = Group::Pdo,
          .run = holds_what_uploads_give},
    Check{.id = "pdo.new-mapping",
          .name = "A new mapping is taken by the procedure and takes effect",
          .clause = "CiA 301 7.5.2.38",
          .group = Group::Pdo,
          .run = takes_a_new_mapping},
};

}  // namespace

std::span<const Check> pdo_content_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
