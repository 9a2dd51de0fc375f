#include "tools/canopen-check/checks/shared/process_data.hpp"

#include <algorithm>

#include "tools/canopen-check/core/run/protected_entries.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint16_t kMappingOffset = 0x200, kMostPdos = 512;
constexpr std::uint16_t kFirstOfDevice = 0x1000;
constexpr std::uint32_t kExtended = 0x2000'0000, kStandardBits = 0x7FF;
constexpr std::uint8_t kMostMapped = 64;
constexpr canopen::Duration kProcessed = std::chrono::milliseconds{20};

/// One entry of a mapping.
struct Mapped {
  std::uint16_t index;
  std::uint8_t sub_index, bits;

  [[nodiscard]] bool dummy() const noexcept { return index < kFirstOfDevice; }
};

std::vector<Mapped> mapping_of(Context& context, std::uint16_t parameters) {
  const auto index = static_cast<std::uint16_t>(parameters + kMappingOffset);
  const SdoAnswer count = context.read(index);
  std::vector<Mapped> mapping;
  if (!count.done() || count.number() > kMostMapped) return mapping;
  for (std::uint8_t sub = 1; sub <= count.number(); ++sub) {
    const SdoAnswer entry = context.read(index, sub);
    if (!entry.done()) return {};
    const std::uint64_t word = entry.number();
    mapping.push_back({.index = static_cast<std::uint16_t>(word >> 16U),
                       .sub_index = static_cast<std::uint8_t>(word >> 8U),
                       .bits = static_cast<std::uint8_t>(word)});
  }
  return mapping;
}

bool may_write(const Context& context, const Mapped& mapped) {
  if (mapped.dummy()) return true;
  const eds::EntryFacts* const facts = context.eds().find(mapped.index, mapped.sub_index);
  Settings still = context.settings();
  still.allow_motion = false;  // values that are made up are for no drive
  return facts != nullptr && write_refusal(*facts, still) == nullptr;
}

/// A frame with the values that there are, but for the bits @p change of the first object.
std::optional<HarmlessRpdo> frame_for(Context& context, const ValidPdo& rpdo, std::uint64_t change) {
  HarmlessRpdo made{.frame = {.id = rpdo.identifier}};
  for (const Mapped& mapped : mapping_of(context, rpdo.parameters)) {
    const std::size_t size = mapped.bits / 8U;
    const SdoAnswer now =
        mapped.dummy() ? SdoAnswer{.kind = SdoAnswer::Kind::Done} : context.read(mapped.index, mapped.sub_index);
    if (mapped.bits % 8U != 0 || made.frame.length + size > made.frame.data.size() || !now.done())
      return std::nullopt;
    std::uint64_t value = now.number();
    if (made.index == 0 && !mapped.dummy()) {
      made.index = mapped.index;
      made.sub_index = mapped.sub_index;
      made.before = value;
      made.after = value ^= change;
    }
    std::ranges::copy(eds::little_endian(value, size), made.frame.data.begin() + made.frame.length);
    made.frame.length = static_cast<std::uint8_t>(made.frame.length + size);
    if (!mapped.dummy()) context.undo().keep(mapped.index, mapped.sub_index);
  }
  if (made.index == 0) return std::nullopt;
  return made;
}

/// True if the frame does in Operational what it should; the value before is back then.
bool works(Context& context, const HarmlessRpdo& rpdo) {
  Session& session = context.session();
  context.enter(canopen::NmtState::Operational);
  session.send(rpdo.frame);
  session.send({.id = sync_identifier(context)});
  session.pass(kProcessed);
  context.enter(canopen::NmtState::PreOperational);
  const bool taken = context.read(rpdo.index, rpdo.sub_index).number() == rpdo.after;
  context.manners().at_work.takes_rpdo_at_once = taken;
  (void)context.write_number(rpdo.index, rpdo.sub_index, rpdo.before);
  return taken && context.read(rpdo.index, rpdo.sub_index).number() == rpdo.before;
}

}  // namespace

std::vector<ValidPdo> valid_pdos(Context& context, std::uint16_t first) {
  constexpr std::uint16_t kPredefined = 4;
  std::vector<std::uint16_t> indices;
  if (!context.eds().empty()) {
    indices = context.eds().objects_within(first, static_cast<std::uint16_t>(first + kMostPdos - 1));
  } else {
    for (std::uint16_t i = 0; i < kPredefined; ++i) indices.push_back(static_cast<std::uint16_t>(first + i));
  }
  std::vector<ValidPdo> pdos;
  for (const std::uint16_t index : indices) {
    const SdoAnswer cob_id = context.read(index, 1);
    const auto word = static_cast<std::uint32_t>(cob_id.number());
    if (cob_id.done() && (word & (kInvalid | kExtended)) == 0) pdos.push_back({index, word & kStandardBits});
  }
  return pdos;
}

const ValidPdo* pdo_of(const std::vector<ValidPdo>& pdos, const canopen::Frame& frame) noexcept {
  if (frame.remote || frame.extended) return nullptr;
  const auto at = std::ranges::find(pdos, frame.id, &ValidPdo::identifier);
  return at == pdos.end() ? nullptr : &*at;
}

bool harmless(Context& context, const ValidPdo& rpdo) {
  const std::vector<Mapped> mapping = mapping_of(context, rpdo.parameters);
  return !mapping.empty() &&
         std::ranges::all_of(mapping, [&](const Mapped& mapped) { return may_write(context, mapped); });
}

std::optional<HarmlessRpdo> working_rpdo(Context& context) {
  for (const ValidPdo& rpdo : valid_pdos(context, object::kRpdoParameter)) {
    if (!harmless(context, rpdo)) continue;
    const std::optional<HarmlessRpdo> made = frame_for(context, rpdo, 1);
    if (made && works(context, *made)) return made;
  }
  context.skip("no valid RPDO is mapped to objects that may be written and read back");
  return std::nullopt;
}

std::optional<canopen::Frame> unchanged(Context& context, const ValidPdo& rpdo) {
  if (!harmless(context, rpdo)) return std::nullopt;
  const std::optional<HarmlessRpdo> made = frame_for(context, rpdo, 0);
  if (!made) return std::nullopt;
  return made->frame;
}

bool follows_sync(Context& context, const ValidPdo& tpdo, std::uint32_t identifier) {
  Session& session = context.session();
  session.drain();
  session.send({.id = identifier});
  return session.wait_for(under(tpdo.identifier), kProcessed).has_value();
}

std::optional<ValidPdo> synchronous_tpdo(Context& context) {
  constexpr std::uint8_t kTransmissionType = 2;
  constexpr std::size_t kMostTried = 4;
  std::vector<ValidPdo> tpdos = valid_pdos(context, object::kTpdoParameter);
  if (tpdos.size() > kMostTried) tpdos.resize(kMostTried);
  const std::uint32_t sync = sync_identifier(context);
  for (const ValidPdo& tpdo : tpdos) {
    if (!context.write_number(tpdo.parameters, kTransmissionType, 1).done()) continue;
    context.enter(canopen::NmtState::Operational);
    context.session().pass(kProcessed);
    const bool follows = follows_sync(context, tpdo, sync);
    context.enter(canopen::NmtState::PreOperational);
    if (follows) return tpdo;
  }
  context.skip("no TPDO is seen to follow SYNC");
  return std::nullopt;
}

std::uint32_t sync_identifier(Context& context) {
  constexpr std::uint32_t kDefault = 0x80;
  const SdoAnswer cob_id = context.read(object::kCobIdSync);
  return cob_id.done() ? static_cast<std::uint32_t>(cob_id.number()) & kStandardBits : kDefault;
}

}  // namespace conformance
