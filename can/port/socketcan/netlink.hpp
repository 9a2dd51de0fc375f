#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>

#include <linux/rtnetlink.h>

/// Reading rtnetlink messages, whose parts may lie anywhere in memory.
namespace bus::netlink {

/// Copies the header of type T off the front of @p bytes.
template <class T>
std::optional<T> front(std::span<const std::byte> bytes) noexcept {
  if (bytes.size() < sizeof(T)) return std::nullopt;
  T value{};
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

/// @p bytes without the first @p size ones and their padding to four bytes.
inline std::span<const std::byte> after(std::span<const std::byte> bytes, std::size_t size) noexcept {
  return bytes.subspan(std::min(bytes.size(), (size + 3) & ~std::size_t{3}));
}

/// Value of the attribute @p type in @p attributes, empty if it is missing.
inline std::span<const std::byte> attribute(std::span<const std::byte> attributes, unsigned short type) noexcept {
  while (const auto header = front<rtattr>(attributes)) {
    if (header->rta_len < sizeof(rtattr) || header->rta_len > attributes.size()) break;
    if ((header->rta_type & NLA_TYPE_MASK) == type)
      return attributes.subspan(sizeof(rtattr), header->rta_len - sizeof(rtattr));
    attributes = after(attributes, header->rta_len);
  }
  return {};
}

}  // namespace bus::netlink
