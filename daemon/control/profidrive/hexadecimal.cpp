#include "daemon/control/profidrive/hexadecimal.hpp"

#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "text/number.hpp"

namespace axisd {
namespace {

constexpr std::size_t kDigits = 2;  // a byte
constexpr int kBase = 16;

std::string expected_text(const ByteCount& count) {
  const std::string bytes =
      count.least == count.most ? fmt::format("{}", count.most) : fmt::format("{} to {}", count.least, count.most);
  return fmt::format("{} bytes of two hexadecimal digits each", bytes);
}

/// The bytes of @p digits, of @p most at most.
std::optional<std::vector<std::uint8_t>> bytes_in(std::string_view digits, std::size_t most) {
  std::vector<std::uint8_t> bytes;
  while (!digits.empty()) {
    if (digits.front() == ' ') {
      digits.remove_prefix(1);
      continue;
    }
    const auto byte = text::integer<std::uint8_t>(digits.substr(0, kDigits), kBase);
    if (!byte || digits.size() < kDigits || bytes.size() == most) return std::nullopt;
    bytes.push_back(*byte);
    digits.remove_prefix(kDigits);
  }
  return bytes;
}

}  // namespace

Taken<std::vector<std::uint8_t>> required_bytes(const nlohmann::json& params, std::string_view key,
                                                const ByteCount& count) {
  const nlohmann::json* const value = Arguments{params}.find(key);
  const auto refused = [&] { return tl::unexpected{unexpected_value(key, expected_text(count), value)}; };
  if (value == nullptr || !value->is_string()) return refused();
  auto bytes = bytes_in(value->get_ref<const std::string&>(), count.most);
  if (!bytes || bytes->size() < count.least) return refused();
  return *std::move(bytes);
}

std::string hexadecimal(std::span<const std::uint8_t> bytes) {
  return fmt::format("{:02X}", fmt::join(bytes, ""));
}

}  // namespace axisd
