#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace gateway {

/// Host and port, as in the header Host and in a URL (RFC 3986, 3.2).
struct Authority {
  std::string host;                   ///< in lower case; an IPv6 address without its brackets
  std::optional<std::uint16_t> port;  ///< nothing: not said

  /// As it is written.
  [[nodiscard]] std::string text() const;
  friend bool operator==(const Authority&, const Authority&) = default;
};

/// Reads `NAME`, `ADDRESS` or `[IPV6]`, each with or without `:PORT`; nothing if @p text is none of them.
[[nodiscard]] std::optional<Authority> parse_authority(std::string_view text);

/// Where a web page comes from (RFC 6454).
struct Origin {
  std::string scheme;  ///< "http" or "https"
  Authority authority;

  /// As it is written.
  [[nodiscard]] std::string text() const { return scheme + "://" + authority.text(); }
};

/// Reads `http://HOST[:PORT]` or `https://`; nothing for all else, "null" included.
[[nodiscard]] std::optional<Origin> parse_origin(std::string_view text);

/// Whether @p host is an IPv4 or IPv6 address.
[[nodiscard]] bool is_ip_address(const std::string& host) noexcept;
/// Whether @p host, in lower case, can only mean this machine: localhost, 127.0.0.0/8, ::1.
[[nodiscard]] bool is_loopback(const std::string& host) noexcept;
/// Whether @p address stands for all addresses of the machine: 0.0.0.0, ::.
[[nodiscard]] bool is_wildcard(const std::string& address) noexcept;

}  // namespace gateway
