#pragma once

#include "tests/tools/canopen-check/slave/slave.hpp"

namespace conformance_test {

// What defects look for in the traffic of a slave with node-ID 5, and what they do about it.

/// True for the NMT command @p command, to any node.
[[nodiscard]] bool is_command(const canopen::Frame& frame, canopen::NmtCommand command);
/// True for a request to write at most four bytes to an entry.
[[nodiscard]] bool writes(const canopen::Frame& frame, std::uint16_t index, std::uint8_t sub_index = 0);
/// True for the answer with at most four bytes of an entry.
[[nodiscard]] bool shows(const canopen::Frame& frame, std::uint16_t index, std::uint8_t sub_index = 0);
/// The four bytes of data of a request or answer.
[[nodiscard]] std::uint32_t value_of(const canopen::Frame& frame);
/// Confirms the write @p request without doing it.
void confirm(Slave& slave, const canopen::Frame& request);
/// Refuses the write @p request.
void refuse(Slave& slave, const canopen::Frame& request, std::uint32_t code);
/// Confirms it, and shows the value from now on; nothing else follows from it.
void pretend(Slave& slave, const canopen::Frame& request);
/// What the dictionary holds.
[[nodiscard]] std::int64_t stored(Slave& slave, std::uint16_t index, std::uint8_t sub_index = 0);

/// A slave that hangs from a frame that @p kills on, until a reset if @p comes_back, else for good.
[[nodiscard]] Defect hangs_on(std::function<bool(const canopen::Frame&)> kills, bool comes_back = true);

/// True for an emergency message with @p code.
[[nodiscard]] bool is_emergency(const canopen::Frame& frame, std::uint16_t code);
/// True if the tester plays node @p detail of an emergency message about a heartbeat.
[[nodiscard]] bool of_heartbeat(const canopen::Frame& emergency);

// A slave of node-ID 5.
inline constexpr std::uint32_t kEmcyOf5 = 0x085, kResponseOf5 = 0x585, kRequestOf5 = 0x605,
                               kErrorControlOf5 = 0x705;

}  // namespace conformance_test
