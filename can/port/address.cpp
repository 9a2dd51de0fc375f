#include "can/port/address.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include <arpa/inet.h>
#include <fmt/format.h>
#include <net/if.h>

#include "can/userbus/path.hpp"
#include "text/number.hpp"

namespace bus {

namespace {

using Parsed = tl::expected<Address, std::string>;

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr std::size_t kLongestName = IFNAMSIZ - 1;
constexpr std::size_t kLongestBusName = 64;
constexpr std::string_view kInterfaceKey = "interface=";

tl::unexpected<std::string> expected(std::string what) {
  return tl::unexpected{std::move(what)};
}

/// What the kernel takes as a name of a network interface.
bool is_interface_name(std::string_view name) noexcept {
  return !name.empty() && name.size() <= kLongestName && name != "." && name != ".." &&
         name.find_first_of("/:") == std::string_view::npos &&
         name.find_first_of(kBlanks) == std::string_view::npos;
}

/// Host and port of "HOST:PORT" or "[HOST]:PORT".
struct Endpoint {
  std::string host;
  std::uint16_t port = 0;
  bool in_brackets = false;
};

std::optional<std::uint16_t> read_port(std::string_view text) noexcept {
  const auto port = text::integer<std::uint16_t>(text);
  return port != 0U ? port : std::nullopt;
}

tl::expected<Endpoint, std::string> read_endpoint(std::string_view text, std::string_view host_name) {
  const bool in_brackets = text.starts_with('[');
  const std::size_t bracket = in_brackets ? text.find(']') : 0;
  if (bracket == std::string_view::npos) return expected(fmt::format("a ] behind the {}", host_name));
  const std::size_t colon = text.find(':', bracket);
  const std::size_t end = in_brackets ? bracket + 1 : std::min(colon, text.size());
  const auto port = colon == end ? read_port(text.substr(colon + 1)) : std::nullopt;
  if (!port) return expected(fmt::format("a port 1 to 65535 behind the {}", host_name));
  const std::string_view host = in_brackets ? text.substr(1, bracket - 1) : text.substr(0, end);
  if (host.empty() || host.find_first_of(kBlanks) != std::string_view::npos)
    return expected(fmt::format("a {} before the port", host_name));
  return Endpoint{std::string{host}, *port, in_brackets};
}

/// @p text as the C library prints the address of @p family that it stands for.
template <class Fits>
std::optional<std::string> normal_address(const std::string& text, int family, const Fits& fits) {
  std::array<unsigned char, sizeof(in6_addr)> address{};
  std::array<char, INET6_ADDRSTRLEN> printed{};
  if (::inet_pton(family, text.c_str(), address.data()) != 1 || !fits(address[0])) return std::nullopt;
  if (::inet_ntop(family, address.data(), printed.data(), printed.size()) == nullptr) return std::nullopt;
  return printed.data();
}

/// The same of a multicast group.
std::optional<std::string> normal_group(const std::string& text, bool six) {
  return normal_address(text, six ? AF_INET6 : AF_INET,
                        [&](unsigned char first) { return six ? first == 0xFF : first >> 4 == 0xE; });
}

Parsed parse_name(std::string_view text, std::string_view) {
  if (!is_interface_name(text))
    return expected(
        "a name of 1 to 15 characters without spaces, unix:PATH, udp-multicast://GROUP:PORT[?interface=NAME] or "
        "socketcand://HOST:PORT/NAME");
  return Address{std::string{text}, KernelInterface{std::string{text}}};
}

Parsed parse_user_bus(std::string_view text, std::string_view rest) {
  userbus::Path path{};
  const auto too_long = [](std::string_view what) {
    return expected(fmt::format("{} of at most {} bytes", what, userbus::kLongestPath));
  };
  if (rest.find('\0') != std::string_view::npos) return expected("a path without a zero byte behind unix:");
  if (rest.empty()) {
    if (!userbus::default_path(path)) return too_long("a default bus ($CAN_BUS, $XDG_RUNTIME_DIR/can-bus)");
    return Address{fmt::format("{}{}", text, path.text), UserBusPath{path.text}};
  }
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(rest, error).lexically_normal();
  if (error || whole.filename().empty()) return expected("the path of a socket behind unix:");
  if (!userbus::copy_path(whole.c_str(), path)) return too_long("an absolute path");
  return Address{std::string{text}, UserBusPath{path.text}};
}

Parsed parse_multicast(std::string_view text, std::string_view rest) {
  const std::size_t mark = rest.find('?');
  const auto endpoint = read_endpoint(rest.substr(0, mark), "group");
  if (!endpoint) return tl::unexpected{endpoint.error()};
  const auto group = normal_group(endpoint->host, endpoint->in_brackets);
  if (!group) return expected("a multicast group, 224.0.0.0 to 239.255.255.255 or [ff00::] to [ffff:...]");
  MulticastGroup place{*group, endpoint->port, {}};
  if (mark != std::string_view::npos) {
    const std::string_view query = rest.substr(mark + 1);
    if (query.starts_with(kInterfaceKey)) place.interface = query.substr(kInterfaceKey.size());
    if (!is_interface_name(place.interface)) return expected("interface=NAME behind the question mark");
  }
  return Address{std::string{text}, std::move(place)};
}

Parsed parse_socketcand(std::string_view text, std::string_view rest) {
  const std::size_t slash = rest.find('/');
  auto endpoint = read_endpoint(rest.substr(0, slash), "host");
  if (!endpoint) return tl::unexpected{endpoint.error()};
  const std::string_view name = slash == std::string_view::npos ? std::string_view{} : rest.substr(slash + 1);
  const auto is_plain = [](char letter) {
    return letter > ' ' && letter <= '~' && letter != '<' && letter != '>';
  };
  if (name.empty() || name.size() > kLongestBusName || !std::all_of(name.begin(), name.end(), is_plain))
    return expected(
        fmt::format("/NAME of the bus, 1 to {} characters without spaces, behind the port", kLongestBusName));
  return Address{std::string{text},
                 SocketcandServer{std::move(endpoint->host), endpoint->port, std::string{name}}};
}

/// A form of address by its beginning.
struct Scheme {
  std::string_view prefix;
  Parsed (*parse)(std::string_view text, std::string_view rest);
};
constexpr std::array kSchemes{
    Scheme{"unix:", parse_user_bus}, Scheme{"udp-multicast://", parse_multicast},
    Scheme{"socketcand://", parse_socketcand}, Scheme{"", parse_name},  // the rest
};

/// What makes up the label of a URL.
struct LabelParts {
  std::string_view scheme;
  std::string readable;
  std::string whole;  ///< tells it from every other address
};

std::optional<LabelParts> parts_of(const KernelInterface&) {
  return std::nullopt;
}
std::optional<LabelParts> parts_of(const UserBusPath& place) {
  return LabelParts{"unix", std::filesystem::path{place.path}.filename(), place.path};
}
std::optional<LabelParts> parts_of(const MulticastGroup& place) {
  return LabelParts{"udp-multicast", place.group,
                    fmt::format("{} {} {}", place.group, place.port, place.interface)};
}
std::optional<LabelParts> parts_of(const SocketcandServer& place) {
  return LabelParts{"socketcand", place.bus, fmt::format("{} {} {}", place.host, place.port, place.bus)};
}

/// FNV-1a: short, and the same on every machine and in every version.
std::uint32_t hash_of(std::string_view text) noexcept {
  constexpr std::uint32_t kBasis = 2166136261U;
  constexpr std::uint32_t kPrime = 16777619U;
  std::uint32_t hash = kBasis;
  for (const char letter : text) hash = (hash ^ static_cast<unsigned char>(letter)) * kPrime;
  return hash;
}

/// The first letters of @p text, fit for a file name.
std::string plain_beginning(std::string_view text) {
  constexpr std::size_t kLongest = 15;
  std::string plain{text.substr(0, kLongest)};
  const auto is_odd = [](char letter) {
    const bool is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
    return !is_letter && !(letter >= '0' && letter <= '9') && letter != '.' && letter != '-' && letter != '_';
  };
  std::replace_if(plain.begin(), plain.end(), is_odd, '_');
  return plain;
}

}  // namespace

tl::expected<Address, std::string> parse_address(std::string_view text) {
  const auto* const scheme = std::find_if(kSchemes.begin(), kSchemes.end(),
                                          [text](const Scheme& row) { return text.starts_with(row.prefix); });
  return scheme->parse(text, text.substr(scheme->prefix.size()));
}

std::string label(const Address& address) {
  const auto parts = std::visit([](const auto& place) { return parts_of(place); }, address.place);
  if (!parts) return address.text;
  return fmt::format("{}-{}-{:08x}", parts->scheme, plain_beginning(parts->readable), hash_of(parts->whole));
}

std::optional<std::string> normal_ip_address(const std::string& text) {
  const auto any = [](unsigned char) { return true; };
  const auto four = normal_address(text, AF_INET, any);
  return four ? four : normal_address(text, AF_INET6, any);
}

}  // namespace bus
