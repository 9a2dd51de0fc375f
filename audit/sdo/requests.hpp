#pragma once

#include <cstdint>

#include "libcanopen/base/frame.hpp"
#include "libcanopen/sdo/command.hpp"

namespace audit {

/// Bytes of a request and of an answer of SDO.
constexpr std::uint8_t kSdoBytes = 8;

/// Whether @p byte is the command of a request that CiA 301 knows, with its reserved bits zero.
[[nodiscard]] bool is_request(std::uint8_t byte) noexcept;
/// Whether a request with the command @p byte begins a transfer.
[[nodiscard]] bool begins_transfer(std::uint8_t byte) noexcept;
/// Command byte of an abort; in a block it would be a segment with the number 0.
constexpr std::uint8_t kAbortByte = 0x80;
/// The abort code in @p frame.
[[nodiscard]] std::uint32_t abort_code_in(const canopen::Frame& frame) noexcept;
/// The command of the answer @p frame.
[[nodiscard]] canopen::sdo::Response response_of(const canopen::Frame& frame) noexcept;

}  // namespace audit
