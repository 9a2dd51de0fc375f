#pragma once

#include <cstdint>
#include <span>

#include "device/objects/configuration.hpp"
#include "unit/unit_parameters.hpp"

namespace device {

/// The node-ID of a unit with @p configuration whose address switch stands at 0: p8620 as the presets have it,
/// else as @p saved has it, an image of such a unit, else 126 as from the factory. An image that does not fit
/// counts as none.
[[nodiscard]] std::uint8_t address_without_switch(const Configuration& configuration,
                                                  std::span<const std::byte> saved);

/// Answers for p8620 and r8621. An address switch above 0 shows in both, whatever was saved; at 0 p8620 is what
/// was written, for the next power-on, and r8621 the address in force.
class NodeAddress final : public unit::ParameterOwner {
 public:
  /// Answers in @p parameters, which this must outlive, for a unit with @p configuration.
  NodeAddress(const Configuration& configuration, unit::UnitParameters& parameters)
      : address_{configuration.node_id}, is_by_switch_{!configuration.address_switch_off} {
    parameters.answer(kStored, kActive, *this);
  }

  std::optional<double> value_of(const unit::ParameterPlace& place) const noexcept override {
    const bool shown = is_by_switch_ || place.row.number == kActive;
    return shown ? std::optional<double>{address_} : std::nullopt;
  }

 private:
  static constexpr std::uint16_t kStored = 8620;
  static constexpr std::uint16_t kActive = 8621;

  std::uint8_t address_;
  bool is_by_switch_;
};

}  // namespace device
