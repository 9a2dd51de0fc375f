#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "libcanopen/base/frame.hpp"

namespace scenario {

/// What a frame has to be.
struct FramePattern {
  std::uint32_t identifier = 0, identifier_mask = 0;
  bool extended = false;
  bool any_content = false;  ///< data or remote, whatever is in it
  bool remote = false;
  bool longer = false;  ///< further bytes may follow
  std::uint8_t length = 0;
  std::array<std::uint8_t, 8> data{}, mask{};

  [[nodiscard]] bool fits(const canopen::Frame& frame) const noexcept;
};

/// "205#0F00", "705#R", "185#" (no data): a frame; nothing if @p text is none.
[[nodiscard]] std::optional<canopen::Frame> parse_frame(std::string_view text);
/// "185" (whatever is in it), "18x#37xx", "585#80*": a pattern; nothing if @p text is none.
[[nodiscard]] std::optional<FramePattern> parse_pattern(std::string_view text);
/// "FF00": 0 to 8 bytes.
struct Bytes {
  std::uint8_t length = 0;
  std::array<std::uint8_t, 8> data{};
};
[[nodiscard]] std::optional<Bytes> parse_bytes(std::string_view text);

}  // namespace scenario
