#include "eds/document/encoding.hpp"

#include <algorithm>

namespace eds {
namespace {

/// The first byte of UTF-8 characters of one length, and the smallest of their numbers.
struct Lead {
  unsigned char mask, bits;
  std::size_t length;
  std::uint32_t smallest;
};
constexpr std::array kLeads{Lead{0x80, 0x00, 1, 0}, Lead{0xE0, 0xC0, 2, 0x80}, Lead{0xF0, 0xE0, 3, 0x800},
                            Lead{0xF8, 0xF0, 4, 0x10000}};

constexpr std::uint32_t kHighest = 0x10FFFF;
constexpr bool is_surrogate(std::uint32_t number) {
  return number >= 0xD800 && number < 0xE000;
}

constexpr char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::size_t utf8_length(std::string_view text) noexcept {
  if (text.empty()) return 0;
  const auto first = static_cast<unsigned char>(text.front());
  const auto* const lead =
      std::ranges::find_if(kLeads, [first](const Lead& row) { return (first & row.mask) == row.bits; });
  if (lead == kLeads.end() || lead->length > text.size()) return 0;
  auto number = static_cast<std::uint32_t>(first & ~lead->mask);
  for (const char c : text.substr(1, lead->length - 1)) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80) return 0;
    number = number << 6U | (byte & 0x3FU);
  }
  return number < lead->smallest || number > kHighest || is_surrogate(number) ? 0 : lead->length;
}

Encoding encoding_of(std::string_view text) noexcept {
  const auto is_ascii = [](char c) { return (static_cast<unsigned char>(c) & 0x80U) == 0; };
  auto encoding = Encoding::Ascii;
  for (;;) {
    const auto* const other = std::ranges::find_if_not(text, is_ascii);
    if (other == text.end()) return encoding;
    text.remove_prefix(static_cast<std::size_t>(other - text.begin()));
    const std::size_t length = utf8_length(text);
    if (length == 0) return Encoding::Latin1;
    encoding = Encoding::Utf8;
    text.remove_prefix(length);
  }
}

std::string utf8_of_latin1(unsigned char byte) {
  if (byte < 0x80) return {static_cast<char>(byte)};
  return {static_cast<char>(0xC0U | byte >> 6U), static_cast<char>(0x80U | (byte & 0x3FU))};
}

std::string_view trimmed(std::string_view text) noexcept {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return text.substr(text.size());
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string lower_case(std::string_view text) {
  std::string result{text};
  std::ranges::transform(result, result.begin(), lower);
  return result;
}

bool equal_in_any_case(std::string_view one, std::string_view other) noexcept {
  return std::ranges::equal(one, other, [](char a, char b) { return lower(a) == lower(b); });
}

bool take_in_any_case(std::string_view& text, std::string_view prefix) noexcept {
  if (!equal_in_any_case(text.substr(0, prefix.size()), prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

}  // namespace eds
