#include "device/process_data/positioner_wiring.hpp"

#include <algorithm>

#include "device/objects/object_index.hpp"
#include "device/process_data/positioner_wiring_rows.hpp"
#include "libcanopen/base/cob_id.hpp"

namespace device {
namespace {

using namespace positioner_wiring;
using Presets = std::vector<unit::ParameterPreset>;

/// The parameters of the PDOs of a direction, of the first one.
struct PdoDirection {
  std::uint16_t communication;
  std::uint16_t mapping;
  std::uint32_t first_cob_id;  ///< without the node-ID
  std::uint32_t flags;
};
constexpr PdoDirection kReceivePdos{8700, 8710, 0x200, 0};
constexpr PdoDirection kTransmitPdos{8720, 8730, 0x180, canopen::cob_id::kNoRemote};
constexpr std::uint16_t kPdosOfAnAxis = 8;
constexpr std::uint32_t kCobIdStep = 0x100;
constexpr std::uint32_t kUnused = canopen::cob_id::kInvalid | 0x6DF;  ///< as the unit delivers invalid PDOs

constexpr std::uint16_t kMappingConfiguration = 8744;
constexpr double kFreeMapping = 2.0;
constexpr std::uint16_t kMainSetpoint = 1070, kSetpointBehindRamp = 1155, kWrittenVelocity = 8796;
constexpr std::uint16_t kBitsOfWord = 8880;
constexpr std::size_t kConverters = 5;
constexpr StatusWord kNoBits{};

/// Entry @p entry of the first axis on the axis at place @p module.
double entry_on(std::uint32_t entry, std::uint8_t module) noexcept {
  constexpr unsigned kIndexAt = 16;
  if (entry == 0) return 0.0;
  const auto index = static_cast<std::uint16_t>(entry >> kIndexAt);
  const std::uint16_t moved = index < object::kFirstProfileObject ? object::free_on_axis(index, module + 1U)
                                                                  : object::on_axis(index, module + 1U);
  return static_cast<double>(std::uint32_t{moved} << kIndexAt | (entry & 0xFFFFU));
}

void put_mappings(const PdoDirection& direction, const std::array<Mapping, 4>& mappings, std::uint8_t module,
                  Presets& presets) {
  for (std::uint16_t pdo = 0; pdo < kPdosOfAnAxis; ++pdo) {
    const Mapping mapping = pdo < mappings.size() ? mappings[pdo] : Mapping{};
    std::uint8_t index = 0;
    for (const std::uint32_t entry : mapping)
      presets.push_back({static_cast<std::uint16_t>(direction.mapping + pdo), entry_on(entry, module), index++});
  }
}

void put_cob_ids(const PdoDirection& direction, const std::array<Mapping, 4>& mappings, const WiredAxis& axis,
                 Presets& presets) {
  for (std::uint16_t pdo = 0; pdo < kPdosOfAnAxis; ++pdo) {
    const auto number = static_cast<std::uint16_t>(direction.communication + pdo);
    const bool is_used = pdo < mappings.size() && mappings[pdo][0] != 0;
    const std::uint32_t predefined = direction.first_cob_id + kCobIdStep * pdo + axis.node_id;
    if (!is_used || axis.module == 0)
      presets.push_back({number, static_cast<double>(direction.flags | (is_used ? predefined : kUnused))});
  }
}

double value_of(const Source& source) noexcept {
  return source.number == 0 ? source.position : drive::own_source(source.number, source.position);
}

bool sets(const Presets& presets, const Connection& connection) noexcept {
  return std::ranges::any_of(presets, [&](const unit::ParameterPreset& preset) {
    return preset.number == connection.input && preset.index == connection.index;
  });
}

/// What only other wirings connect is as on a new axis.
void put_factory_connections(const WiredAxis& axis, Presets& presets) {
  const drive::ObjectContext context{.kind = axis.kind, .module = axis.module};
  for (const Table& table : kTables)
    for (const auto& connections : table.connections)
      for (const Connection& connection : connections) {
        if (sets(presets, connection)) continue;
        const drive::ParameterRow& row = *drive::find_parameter(axis.kind, connection.input)->row;
        presets.push_back({row.number, drive::factory_value(row, context, connection.index), connection.index});
      }
}

}  // namespace

unit::Delivery delivery_of(PositionerWiring wiring, const WiredAxis& axis) {
  const Table& table = kTables[static_cast<std::size_t>(wiring)];
  unit::Delivery delivery;
  put_mappings(kReceivePdos, table.received, axis.module, delivery.identity);
  put_mappings(kTransmitPdos, table.sent, axis.module, delivery.identity);
  Presets& presets = delivery.values;
  presets = {{kMappingConfiguration, kFreeMapping},
             {axis.setpoint_channel ? kMainSetpoint : kSetpointBehindRamp, value_of({kWrittenVelocity, 0})}};
  put_cob_ids(kReceivePdos, table.received, axis, presets);
  put_cob_ids(kTransmitPdos, table.sent, axis, presets);
  for (const auto& connections : table.connections)
    for (const Connection& connection : connections)
      presets.push_back({connection.input, value_of(connection.source), connection.index});
  for (std::size_t word = 0; word < kConverters; ++word) {
    const StatusWord& bits = word < table.words.size() ? *table.words[word] : kNoBits;
    std::uint8_t index = 0;
    for (const Source& bit : bits)
      presets.push_back({static_cast<std::uint16_t>(kBitsOfWord + word), value_of(bit), index++});
  }
  put_factory_connections(axis, presets);
  return delivery;
}

}  // namespace device
