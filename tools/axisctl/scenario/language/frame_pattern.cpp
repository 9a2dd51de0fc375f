#include "tools/axisctl/scenario/language/frame_pattern.hpp"

#include <algorithm>

namespace scenario {
namespace {

constexpr std::size_t kStandardDigits = 3, kExtendedDigits = 8;
constexpr std::uint32_t kHighestStandard = 0x7FF, kHighestExtended = 0x1FFFFFFF;
constexpr std::uint8_t kDigit = 0xF;
constexpr unsigned kDigitBits = 4;

/// A hexadecimal digit, or x for any.
struct Digit {
  std::uint8_t value;
  std::uint8_t mask;
};

std::optional<Digit> digit_of(char c) noexcept {
  if (c >= '0' && c <= '9') return Digit{static_cast<std::uint8_t>(c - '0'), kDigit};
  if (c >= 'a' && c <= 'f') return Digit{static_cast<std::uint8_t>(c - 'a' + 10), kDigit};
  if (c >= 'A' && c <= 'F') return Digit{static_cast<std::uint8_t>(c - 'A' + 10), kDigit};
  if (c == 'x' || c == 'X') return Digit{0, 0};
  return std::nullopt;
}

bool read_identifier(std::string_view text, FramePattern& pattern) {
  if (text.size() != kStandardDigits && text.size() != kExtendedDigits) return false;
  pattern.extended = text.size() == kExtendedDigits;
  for (const char c : text) {
    const auto digit = digit_of(c);
    if (!digit) return false;
    pattern.identifier = pattern.identifier << kDigitBits | digit->value;
    pattern.identifier_mask = pattern.identifier_mask << kDigitBits | digit->mask;
  }
  return pattern.identifier <= (pattern.extended ? kHighestExtended : kHighestStandard);
}

bool read_data(std::string_view text, FramePattern& pattern) {
  if (text.size() % 2 != 0 || text.size() / 2 > pattern.data.size()) return false;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const auto high = digit_of(text[i]), low = digit_of(text[i + 1]);
    if (!high || !low) return false;
    pattern.data[i / 2] = static_cast<std::uint8_t>(high->value << kDigitBits | low->value);
    pattern.mask[i / 2] = static_cast<std::uint8_t>(high->mask << kDigitBits | low->mask);
  }
  pattern.length = static_cast<std::uint8_t>(text.size() / 2);
  return true;
}

/// What stands behind the identifier.
bool read_content(std::string_view text, FramePattern& pattern) {
  if (text.starts_with('R')) {
    pattern.remote = true;
    pattern.longer = text.size() == 1;
    if (text.size() == 1) return true;
    const char digit = text[1];
    pattern.length = static_cast<std::uint8_t>(digit - '0');
    return text.size() == 2 && digit >= '0' && digit <= '8';
  }
  pattern.longer = text.ends_with('*');
  if (pattern.longer) text.remove_suffix(1);
  return read_data(text, pattern);
}

}  // namespace

bool FramePattern::fits(const canopen::Frame& frame) const noexcept {
  if (frame.extended != extended || (frame.id & identifier_mask) != identifier) return false;
  if (any_content) return true;
  if (frame.remote != remote || frame.length < length || (!longer && frame.length != length)) return false;
  if (remote) return true;
  for (std::size_t i = 0; i < length; ++i)
    if ((frame.data[i] & mask[i]) != (data[i] & mask[i])) return false;
  return true;
}

std::optional<FramePattern> parse_pattern(std::string_view text) {
  FramePattern pattern;
  const std::size_t hash = text.find('#');
  if (!read_identifier(text.substr(0, hash), pattern)) return std::nullopt;
  pattern.any_content = hash == std::string_view::npos;
  if (!pattern.any_content && !read_content(text.substr(hash + 1), pattern)) return std::nullopt;
  return pattern;
}

std::optional<canopen::Frame> parse_frame(std::string_view text) {
  const auto pattern = parse_pattern(text);
  if (!pattern || text.find_first_of("xX*") != std::string_view::npos || pattern->any_content) return std::nullopt;
  canopen::Frame frame{.id = pattern->identifier, .length = pattern->length};
  frame.remote = pattern->remote;
  frame.extended = pattern->extended;
  frame.data = pattern->data;
  return frame;
}

std::optional<Bytes> parse_bytes(std::string_view text) {
  FramePattern pattern;
  if (text.find_first_of("xX") != std::string_view::npos || !read_data(text, pattern)) return std::nullopt;
  return Bytes{.length = pattern.length, .data = pattern.data};
}

}  // namespace scenario
