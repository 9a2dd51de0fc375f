#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace modbus {

/// What @p input makes a connection with a drive unit behind it do against the rules; empty if nothing. A byte n
/// of the input is followed by n bytes that come in one piece; 0 lets the time of a cycle pass, and of the others
/// those from 240 on take a part of the answers away.
///
/// The rules: every answer is a frame with transaction and unit of its request and no more bytes than allowed;
/// each whole request has one, in their order, until the stream ends; nothing is answered behind that.
std::string broken_rule(std::span<const std::uint8_t> input);

}  // namespace modbus
