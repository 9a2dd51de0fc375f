#include "gateway/base/percent.hpp"

#include <algorithm>

#include "text/number.hpp"

namespace gateway {
namespace {

constexpr std::size_t kEncoded = 3;  // characters: %2F
constexpr int kHexadecimal = 16;
constexpr unsigned char kDelete = 0x7F;

bool is_control(unsigned char c) noexcept {
  return c < ' ' || c == kDelete;
}

}  // namespace

std::optional<std::string> decoded(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    auto byte = static_cast<unsigned char>(text[at]);
    if (byte == '%') {
      const std::string_view digits = text.substr(at + 1, kEncoded - 1);
      const auto value = text::integer<unsigned char>(digits, kHexadecimal);
      if (digits.size() != kEncoded - 1 || !value) return std::nullopt;
      byte = *value;
      at += kEncoded - 1;
    }
    if (is_control(byte)) return std::nullopt;
    result += static_cast<char>(byte);
  }
  return result;
}

std::vector<std::string_view> segments_of(std::string_view path) {
  std::vector<std::string_view> segments;
  while (path.starts_with('/')) {
    path.remove_prefix(1);
    const std::size_t end = std::min(path.find('/'), path.size());
    segments.push_back(path.substr(0, end));
    path.remove_prefix(end);
  }
  return segments;
}

std::vector<std::string> list_of(std::string_view text) {
  std::vector<std::string> items;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    items.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return items;
}

}  // namespace gateway
