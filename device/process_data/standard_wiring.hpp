#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "device/process_data/process_data_buffers.hpp"
#include "drive/axis/axis.hpp"

namespace device {

/// The interconnections that a new axis is delivered with between its standard objects and its drive: the
/// controlword (p0840, p0844, p0848, p0852, p2103, while p8790 = 1), p1070 from 60FFh or in velocity mode 6042h
/// (p1155 without extended setpoint channel), p1503 from 6071h, p2151, and the actual values in p8851 and p8861.
/// They follow every later mapping, the mode and the channel, as long as they are what was wired here; what a user
/// has wired stays.
class StandardWiring {
 public:
  /// Of @p axis, whose objects lie where @p places says; both outlive this.
  StandardWiring(drive::Axis& axis, const ProcessDataBuffers& places) noexcept;

  /// The inputs have factory values: they are brought to the mappings that there are.
  void follow_from_factory() noexcept;
  /// The inputs and the mappings were saved together: the inputs are what follow() goes on from.
  void adopt() noexcept;
  /// Mappings, the mode or the setpoint channel may have changed.
  void follow() noexcept;
  /// p8790 = 1: connects the inputs of the controlword, whatever they were connected to.
  void connect_controlword() noexcept;

 private:
  static constexpr std::size_t kCommands = 5;
  static constexpr std::size_t kSetpoints = 4;
  static constexpr std::size_t kSent = ProcessDataLayout::kTransmitWords;
  using Sources = std::array<std::uint32_t, kCommands + kSetpoints + 2 * kSent>;

  Sources wanted() const noexcept;
  Sources factory() const noexcept;
  void wire_commands(Sources& sources) const noexcept;
  void wire_setpoints(Sources& sources) const noexcept;
  void wire_actual_values(Sources& sources) const noexcept;
  std::uint32_t source_of(std::uint16_t object, std::uint16_t written) const noexcept;
  std::uint32_t connected(std::uint16_t input, std::size_t index) const noexcept;
  void connect(std::size_t input, std::uint32_t source) noexcept;

  drive::Axis& axis_;
  const ProcessDataBuffers& places_;
  Sources wired_{};  ///< as it was done here
};

}  // namespace device
