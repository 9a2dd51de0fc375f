// The factory values of CANopen: COB-IDs, mappings, and what the predefined connection set wires.
#include <array>

#include "drive/values/factory_values.hpp"

namespace drive::factory {
namespace {

constexpr std::uint32_t kInvalid = 0x80000000;
constexpr std::uint32_t kNoRemoteFrame = 0x40000000;
constexpr std::uint32_t kHighestCobId = 0x6DF;
constexpr double kOnEvent = 0xFE;
constexpr unsigned kPredefined = 4;  // RPDOs and TPDOs each

using Mapping = std::array<std::uint32_t, 4>;
constexpr std::array<Mapping, kPredefined> kReceiveMappings{{
    {0x60400010},
    {0x60400010, 0x60FF0020},
    {0x60400010, 0x60710010},
    {0x60400010, 0x60FF0020, 0x60710010},
}};
constexpr std::array<Mapping, kPredefined> kTransmitMappings{{
    {0x60410010},
    {0x60410010, 0x606C0020},
    {0x60410010, 0x60770010},
    {0x60410010, 0x60630020},
}};

/// The bit timing register of each bit rate, by p8622.
constexpr std::array<std::uint32_t, 8> kBitTimings{0x1405, 0x1605, 0x1C05,  0x1C0B,
                                                   0x1C17, 0x1C3B, 0x21C15, 0x41C2B};

constexpr std::array<std::uint32_t, 4> kIdentity{0x06000053, 0x5000, 0x00010000, 1};

/// What p8851 (words) and p8861 (double words) send from a place of the process data.
struct Wire {
  std::size_t place;
  std::uint16_t source;
};
constexpr std::array kSendWords{Wire{0, 8784}, Wire{3, 80}};
constexpr std::array kSendDoubleWords{Wire{1, 63}, Wire{4, 482}};

template <std::size_t Count>
double source_at(const std::array<Wire, Count>& wires, const ObjectContext& context, std::size_t place) noexcept {
  if (context.kind == ObjectKind::ControlUnit) return 0.0;
  for (const Wire& wire : wires)
    if (wire.place == place) return own_source(wire.source, 0);
  return 0.0;
}

bool is_predefined(unsigned pdo, const ObjectContext& context) noexcept {
  return pdo < kPredefined && context.module == 0 && context.node_id != 0;
}

/// COB-ID of PDO number @p pdo: @p base and 100h more for each one, or invalid, with @p flags in both cases.
double pdo_cob_id(unsigned pdo, std::uint32_t base, std::uint32_t flags, const ObjectContext& context) noexcept {
  if (!is_predefined(pdo, context)) return flags | kInvalid | kHighestCobId;
  return flags | (base + 0x100 * pdo + context.node_id);
}

/// Entry @p index of @p mapping with the objects of the axis.
double entry_of(const Mapping& mapping, const ObjectContext& context, std::size_t index) noexcept {
  constexpr std::uint32_t kNextAxis = 0x08000000;  // 800h in the index
  const std::uint32_t entry = mapping[index];
  return entry == 0 ? 0.0 : entry + kNextAxis * context.module;
}

}  // namespace

double node_id(const ObjectContext& context, std::size_t) noexcept {
  constexpr double kUnset = 126.0;
  return context.node_id != 0 && !context.address_switch_off ? context.node_id : kUnset;
}
double identity(const ObjectContext&, std::size_t index) noexcept {
  return kIdentity[index];
}
double emergency_cob_id(const ObjectContext& context, std::size_t) noexcept {
  return 0x80U + context.node_id;
}
double server_cob_id(const ObjectContext& context, std::size_t index) noexcept {
  return (index == 0 ? 0x600U : 0x580U) + context.node_id;
}
double bit_timing(const ObjectContext&, std::size_t index) noexcept {
  return kBitTimings[index];
}
double acknowledge_source(const ObjectContext& context, std::size_t) noexcept {
  return contains(kAxes, context.kind) ? own_source(8890, 7) : 0.0;
}
double send_words(const ObjectContext& context, std::size_t index) noexcept {
  return source_at(kSendWords, context, index);
}
double send_double_words(const ObjectContext& context, std::size_t index) noexcept {
  return source_at(kSendDoubleWords, context, index);
}

double receive_pdo_of(unsigned pdo, const ObjectContext& context, std::size_t index) noexcept {
  return index == 0 ? pdo_cob_id(pdo, 0x200, 0, context) : kOnEvent;
}
double transmit_pdo_of(unsigned pdo, const ObjectContext& context, std::size_t index) noexcept {
  if (index == 0) return pdo_cob_id(pdo, 0x180, kNoRemoteFrame, context);
  return index == 1 ? kOnEvent : 0.0;
}
double receive_mapping_of(unsigned pdo, const ObjectContext& context, std::size_t index) noexcept {
  return entry_of(kReceiveMappings[pdo], context, index);
}
double transmit_mapping_of(unsigned pdo, const ObjectContext& context, std::size_t index) noexcept {
  return entry_of(kTransmitMappings[pdo], context, index);
}

}  // namespace drive::factory
