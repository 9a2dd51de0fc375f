#pragma once

#include "tools/canopen-zoo/slave/slave.hpp"

namespace zoo {

// What defects look for in the traffic of a slave, and what they do about it.

/// True for the NMT command @p command, to any node.
[[nodiscard]] bool is_command(const canopen::Frame& frame, canopen::NmtCommand command);
/// True for a request to write at most four bytes to an entry.
[[nodiscard]] bool writes(const Slave& slave, const canopen::Frame& frame, std::uint16_t index,
                          std::uint8_t sub_index = 0);
/// True for the answer with at most four bytes of an entry.
[[nodiscard]] bool shows(const Slave& slave, const canopen::Frame& frame, std::uint16_t index,
                         std::uint8_t sub_index = 0);
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
[[nodiscard]] Defect hangs_on(const std::function<bool(const Slave&, const canopen::Frame&)>& kills,
                              bool comes_back = true);

/// True for an emergency message with @p code.
[[nodiscard]] bool is_emergency(const Slave& slave, const canopen::Frame& frame, std::uint16_t code);
/// True if an emergency message with 8130h is about a heartbeat, whose node-ID it has, not about life guarding.
[[nodiscard]] bool of_heartbeat(const canopen::Frame& emergency);

}  // namespace zoo
