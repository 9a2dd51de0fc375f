#include "tools/axisctl/page/base64.hpp"

#include <cstdint>

namespace axisctl {
namespace {

constexpr std::string_view kDigits{"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"};
constexpr std::size_t kBytes = 3, kDigitsOfBytes = 4;
constexpr unsigned kBitsOfByte = 8, kBitsOfDigit = 6, kDigitMask = 0x3F;

}  // namespace

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + kBytes - 1) / kBytes * kDigitsOfBytes);
  for (std::size_t at = 0; at < bytes.size(); at += kBytes) {
    const std::string_view group = bytes.substr(at, kBytes);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < kBytes; ++i)
      bits = bits << kBitsOfByte | (i < group.size() ? static_cast<std::uint8_t>(group[i]) : 0U);
    for (std::size_t i = 0; i < kDigitsOfBytes; ++i) {
      const auto shift = static_cast<unsigned>(kDigitsOfBytes - 1 - i) * kBitsOfDigit;
      text += i <= group.size() ? kDigits[bits >> shift & kDigitMask] : '=';
    }
  }
  return text;
}

}  // namespace axisctl
