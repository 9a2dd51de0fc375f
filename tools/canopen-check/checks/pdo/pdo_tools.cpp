#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "tools/canopen-check/core/run/protected_entries.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint16_t kPdoNumbers = 512;
constexpr std::uint16_t kPredefined = 4;

std::uint16_t first_index(PdoDirection direction) noexcept {
  return direction == PdoDirection::Receive ? object::kRpdoParameter : object::kTpdoParameter;
}

/// Writes a parameter of @p pdo; the check is skipped where it is refused.
bool configure(Context& context, const Pdo& pdo, std::uint16_t index, std::uint8_t sub_index,
               std::uint64_t value) {
  const SdoAnswer answer = context.write_number(index, sub_index, value);
  if (answer.done()) return true;
  if (const SdoAnswer now = context.read(index, sub_index); now.done() && now.number() == value) return true;
  context.skip(fmt::format("{} cannot be set up: {} = {:X}h: {}", pdo.name(), to_text(Subject{index, sub_index}),
                           value, to_text(answer)));
  return false;
}

/// As configure(), for a parameter that need not exist if @p value is 0.
bool configure_optional(Context& context, const Pdo& pdo, std::uint8_t sub_index,
                        std::optional<std::uint16_t> value) {
  if (!value) return true;
  if (*value == 0 && !has_parameter(context, pdo, sub_index)) return true;
  return configure(context, pdo, pdo.parameters(), sub_index, *value);
}

bool is_valid(Context& context, const Pdo& pdo) {
  const SdoAnswer cob_id = context.read(pdo.parameters(), kCobIdSub);
  return cob_id.done() && (cob_id.number() & kInvalid) == 0;
}

}  // namespace

std::uint16_t Pdo::parameters() const noexcept {
  return static_cast<std::uint16_t>(first_index(direction) + number);
}

std::uint16_t Pdo::mapping() const noexcept {
  return static_cast<std::uint16_t>(parameters() + kPdoNumbers);
}

std::string Pdo::name() const {
  return fmt::format("{} {}", direction == PdoDirection::Receive ? "RPDO" : "TPDO", number + 1);
}

std::vector<Pdo> all_pdos(Context& context, PdoDirection direction) {
  std::vector<Pdo> pdos;
  const std::uint16_t first = first_index(direction);
  if (context.eds().empty()) {
    for (std::uint16_t number = 0; number < kPredefined; ++number)
      if (const Pdo pdo{direction, number}; context.read(pdo.parameters(), kCobIdSub).done()) pdos.push_back(pdo);
    return pdos;
  }
  for (const std::uint16_t index : context.eds().objects_within(first, first + kPdoNumbers - 1))
    if (context.eds().find(index, kCobIdSub) != nullptr)
      pdos.push_back({direction, static_cast<std::uint16_t>(index - first)});
  return pdos;
}

std::optional<Pdo> test_pdo(Context& context, PdoDirection direction) {
  std::vector<Pdo> pdos = all_pdos(context, direction);
  if (!context.eds().empty())
    std::erase_if(pdos, [&](const Pdo& pdo) {
      const eds::EntryFacts* const facts = context.eds().find(pdo.parameters(), kCobIdSub);
      return write_refusal(*facts, context.settings()) != nullptr || !facts->writable();
    });
  if (pdos.empty()) {
    context.skip(fmt::format("the node has no {} that can be configured",
                             direction == PdoDirection::Receive ? "RPDO" : "TPDO"));
    return std::nullopt;
  }
  const auto valid =
      std::find_if(pdos.rbegin(), pdos.rend(), [&](const Pdo& pdo) { return is_valid(context, pdo); });
  if (valid != pdos.rend()) return *valid;
  const auto mapped =
      std::ranges::find_if(pdos, [&](const Pdo& pdo) { return !mapping_of(context, pdo).empty(); });
  return mapped == pdos.end() ? pdos.front() : *mapped;
}

std::vector<Pdo> test_pdos(Context& context) {
  std::vector<Pdo> pdos;
  for (const PdoDirection direction : {PdoDirection::Receive, PdoDirection::Transmit})
    if (const auto pdo = test_pdo(context, direction)) pdos.push_back(*pdo);
  if (!pdos.empty()) context.unskip();
  return pdos;
}

std::uint32_t identifier_of(Context& context, const Pdo& pdo) {
  const auto predefined =
      static_cast<std::uint32_t>((pdo.direction == PdoDirection::Receive ? 0x200 : 0x180) +
                                 0x100 * (pdo.number % kPredefined) + context.session().node_id());
  const SdoAnswer cob_id = context.read(pdo.parameters(), kCobIdSub);
  const auto identifier = static_cast<std::uint32_t>(cob_id.number() & 0x7FF);
  return cob_id.done() && identifier > 0x180 && identifier < 0x580 ? identifier : predefined;
}

bool has_parameter(Context& context, const Pdo& pdo, std::uint8_t sub_index) {
  return context.eds().empty() ? context.read(pdo.parameters(), sub_index).done()
                               : context.eds().find(pdo.parameters(), sub_index) != nullptr;
}

std::vector<MappedObject> mapping_of(Context& context, const Pdo& pdo) {
  std::vector<MappedObject> objects;
  const SdoAnswer count = context.read(pdo.mapping(), 0);
  constexpr std::uint64_t kMostEntries = 64;
  for (std::uint64_t sub = 1; count.done() && sub <= std::min(count.number(), kMostEntries); ++sub)
    if (const SdoAnswer entry = context.read(pdo.mapping(), static_cast<std::uint8_t>(sub)); entry.done())
      objects.push_back(MappedObject::of(static_cast<std::uint32_t>(entry.number())));
  return objects;
}

bool refused_as_empty(Context& context, const Pdo& pdo, const SdoAnswer& answer) {
  if (!answer.aborted() || !mapping_of(context, pdo).empty()) return false;
  context.note(fmt::format("{}, which maps nothing, cannot be enabled: {}", pdo.name(), to_text(answer)));
  return true;
}

bool disable(Context& context, const Pdo& pdo) {
  const SdoAnswer cob_id = context.read(pdo.parameters(), kCobIdSub);
  if (!cob_id.done()) {
    context.skip(
        fmt::format("{} cannot be read: {}", to_text(Subject{pdo.parameters(), kCobIdSub}), to_text(cob_id)));
    return false;
  }
  return configure(context, pdo, pdo.parameters(), kCobIdSub, cob_id.number() | kInvalid);
}

SdoAnswer map_objects(Context& context, const Pdo& pdo, const std::vector<MappedObject>& objects) {
  SdoAnswer answer = context.write_number(pdo.mapping(), 0, 0);
  std::uint8_t sub = 0;
  for (const MappedObject& object : objects) {
    if (!answer.done()) return answer;
    answer = context.write_number(pdo.mapping(), ++sub, object.entry());
  }
  return answer.done() ? context.write_number(pdo.mapping(), 0, sub) : answer;
}

bool set_up(Context& context, const Pdo& pdo, const PdoSetup& setup) {
  const std::uint32_t identifier = identifier_of(context, pdo);
  if (!disable(context, pdo)) return false;
  std::vector<MappedObject> mapping = setup.mapping;
  if (mapping.empty() && mapping_of(context, pdo).empty()) {
    // A PDO that maps nothing carries nothing, whatever else is set up.
    mapping = pdo.direction == PdoDirection::Receive ? receivable(context) : transmittable(context);
    if (mapping.empty()) return context.skip(pdo.name() + " maps nothing, and no object is known for it"), false;
    mapping.resize(1);
  }
  if (!mapping.empty())
    if (const SdoAnswer answer = map_objects(context, pdo, mapping); !answer.done()) {
      context.skip(fmt::format("{} cannot be mapped: {}", pdo.name(), to_text(answer)));
      return false;
    }
  if (setup.type && !configure(context, pdo, pdo.parameters(), kTypeSub, *setup.type)) return false;
  if (!configure_optional(context, pdo, kInhibitSub, setup.inhibit_time)) return false;
  if (!configure_optional(context, pdo, kTimerSub, setup.event_timer)) return false;
  if (!configure_optional(context, pdo, kSyncStartSub, setup.sync_start)) return false;
  const bool forbids = pdo.direction == PdoDirection::Transmit && !setup.remote_requests;
  return configure(context, pdo, pdo.parameters(), kCobIdSub, identifier | (forbids ? kBit30 : 0));
}

}  // namespace conformance
