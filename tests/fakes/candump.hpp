#pragma once

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

#include "libcanopen/base/frame.hpp"
#include "text/number.hpp"

namespace fakes {

/// @p frame as candump -L and cansend write it: "605#4000100000000000", a remote frame "705#R", a 29-bit
/// identifier with eight digits.
inline std::string candump(const canopen::Frame& frame) {
  char digits[9];
  std::snprintf(digits, sizeof digits, frame.extended ? "%08X" : "%03X", frame.id);
  std::string text = std::string{digits} + '#';
  if (frame.remote) return text + 'R' + (frame.length != 0 ? std::to_string(frame.length) : "");
  for (std::size_t i = 0; i < std::min<std::size_t>(frame.length, frame.data.size()); ++i) {
    std::snprintf(digits, sizeof digits, "%02X", frame.data[i]);
    text += digits;
  }
  return text;
}

/// The number that the hexadecimal @p digits spell; throws std::invalid_argument if they are none.
inline std::uint32_t hexadecimal(std::string_view digits) {
  const auto value = text::integer<std::uint32_t>(digits, 16);
  if (!value) throw std::invalid_argument{"not a hexadecimal number: " + std::string{digits}};
  return *value;
}

/// The frame that @p text describes in the same notation, dots between the bytes allowed; throws
/// std::invalid_argument on anything else.
inline canopen::Frame frame_of(std::string_view text) {
  const std::size_t hash = text.find('#');
  if (hash == std::string_view::npos) throw std::invalid_argument{"no # in " + std::string{text}};
  canopen::Frame frame{.id = hexadecimal(text.substr(0, hash)), .extended = hash == 8};
  std::string data{text.substr(hash + 1)};
  std::erase(data, '.');
  if (data.starts_with('R')) {
    frame.remote = true;
    frame.length = data.size() > 1 ? static_cast<std::uint8_t>(data[1] - '0') : std::uint8_t{0};
    return frame;
  }
  if (data.size() > 16 || data.size() % 2 != 0) throw std::invalid_argument{"no data bytes: " + data};
  for (std::size_t i = 0; i < data.size(); i += 2) {
    frame.data[frame.length++] = static_cast<std::uint8_t>(hexadecimal(std::string_view{data}.substr(i, 2)));
  }
  return frame;
}

}  // namespace fakes
