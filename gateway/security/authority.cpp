#include "gateway/security/authority.hpp"

#include <algorithm>
#include <array>

#include <arpa/inet.h>

#include "text/number.hpp"

namespace gateway {
namespace {

constexpr std::size_t kLongestHost = 253;  // RFC 1035
constexpr std::array<std::string_view, 2> kSchemes{"http", "https"};
constexpr std::uint32_t kLoopbackNet = 127;
constexpr unsigned kNetShift = 24;

char lower(char c) noexcept {
  return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string in_lower_case(std::string_view text) {
  std::string result{text};
  std::ranges::transform(result, result.begin(), lower);
  return result;
}

bool is_name_character(char c) noexcept {
  return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '-' || c == '.' || c == '_';
}

bool is_name(std::string_view host) noexcept {
  return !host.empty() && host.size() <= kLongestHost && std::ranges::all_of(host, is_name_character);
}

std::optional<in6_addr> ipv6_of(const std::string& host) noexcept {
  in6_addr address{};
  return ::inet_pton(AF_INET6, host.c_str(), &address) == 1 ? std::optional{address} : std::nullopt;
}

std::optional<std::uint32_t> ipv4_of(const std::string& host) noexcept {
  in_addr address{};
  return ::inet_pton(AF_INET, host.c_str(), &address) == 1 ? std::optional{ntohl(address.s_addr)} : std::nullopt;
}

}  // namespace

std::string Authority::text() const {
  const bool is_ipv6 = host.find(':') != std::string::npos;
  std::string written = is_ipv6 ? '[' + host + ']' : host;
  if (port) written += ':' + std::to_string(*port);
  return written;
}

std::optional<Authority> parse_authority(std::string_view text) {
  Authority authority;
  std::string_view rest;
  if (text.starts_with('[')) {
    const std::size_t end = text.find(']');
    if (end == std::string_view::npos) return std::nullopt;
    authority.host = in_lower_case(text.substr(1, end - 1));
    if (!ipv6_of(authority.host)) return std::nullopt;
    rest = text.substr(end + 1);
  } else {
    const std::size_t end = std::min(text.find(':'), text.size());
    authority.host = in_lower_case(text.substr(0, end));
    if (!is_name(authority.host)) return std::nullopt;
    rest = text.substr(end);
  }
  if (rest.empty()) return authority;
  authority.port = text::integer<std::uint16_t>(rest.substr(1));
  return rest.front() == ':' && authority.port ? std::optional{std::move(authority)} : std::nullopt;
}

std::optional<Origin> parse_origin(std::string_view text) {
  const std::size_t end = text.find("://");
  if (end == std::string_view::npos) return std::nullopt;
  std::string scheme = in_lower_case(text.substr(0, end));
  auto authority = parse_authority(text.substr(end + 3));
  if (!authority || std::ranges::find(kSchemes, scheme) == kSchemes.end()) return std::nullopt;
  return Origin{std::move(scheme), *std::move(authority)};
}

bool is_ip_address(const std::string& host) noexcept {
  return ipv4_of(host) || ipv6_of(host);
}

bool is_loopback(const std::string& host) noexcept {
  if (host == "localhost") return true;
  if (const auto address = ipv4_of(host)) return *address >> kNetShift == kLoopbackNet;
  const auto address = ipv6_of(host);
  return address && IN6_IS_ADDR_LOOPBACK(&*address) != 0;
}

bool is_wildcard(const std::string& address) noexcept {
  const auto six = ipv6_of(address);
  return ipv4_of(address) == 0U || (six && IN6_IS_ADDR_UNSPECIFIED(&*six) != 0);
}

}  // namespace gateway
