#include "control/socket_name.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include <sys/socket.h>
#include <unistd.h>

namespace control {

namespace {

constexpr std::string_view kPrefix = "axisd-";
constexpr std::string_view kSuffix = ".sock";
constexpr int kHighestNode = 127;
constexpr std::string_view kUnconfigured = "unconfigured";

/// Whether @p text is a decimal number 0 to @p most, without a sign.
template <class Number>
bool is_number(std::string_view text, Number most = std::numeric_limits<Number>::max()) noexcept {
  Number number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && rest == end && text.front() != '-' && number <= most;
}

std::string_view environment(const char* name) noexcept {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view{} : std::string_view{value};
}

}  // namespace

std::string runtime_directory() {
  // systemd.exec(5): several folders are separated by colons.
  const std::string_view own = environment("RUNTIME_DIRECTORY");
  if (const std::string_view first = own.substr(0, own.find(':')); !first.empty()) return std::string{first};
  if (const std::string_view user = environment("XDG_RUNTIME_DIR"); !user.empty()) return std::string{user};
  return ::geteuid() == 0 ? "/run" : "/tmp";
}

std::string default_socket_path(std::string_view label, std::string_view station) {
  std::string path = runtime_directory();
  path.append("/").append(kPrefix).append(label).append("-").append(station).append(kSuffix);
  return path;
}

bool is_unconfigured(std::string_view station) noexcept {
  if (!station.starts_with(kUnconfigured)) return false;
  station.remove_prefix(kUnconfigured.size());
  return station.empty() || (station.front() == '-' && is_number<std::uint32_t>(station.substr(1)));
}

bool is_station(std::string_view text) noexcept {
  return is_unconfigured(text) || is_number<int>(text, kHighestNode);
}

std::string common_socket_path() {
  return runtime_directory() + "/axisd.sock";
}

std::optional<SocketName> parse_socket_name(std::string_view file_name) noexcept {
  if (!file_name.starts_with(kPrefix) || !file_name.ends_with(kSuffix)) return std::nullopt;
  if (file_name.size() <= kPrefix.size() + kSuffix.size()) return std::nullopt;
  const std::string_view middle =
      file_name.substr(kPrefix.size(), file_name.size() - kPrefix.size() - kSuffix.size());
  // A serial number is behind a dash of its own.
  const std::size_t dash = middle.rfind('-');
  for (const std::size_t before : {middle.rfind('-', dash - 1), dash}) {
    if (before == std::string_view::npos || before == 0) continue;
    const std::string_view station = middle.substr(before + 1);
    if (is_station(station)) return SocketName{middle.substr(0, before), station};
  }
  return std::nullopt;
}

tl::expected<sockaddr_un, std::string> socket_address(std::string_view path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty()) return tl::unexpected{std::string{"the path of a control socket is empty"}};
  if (path.size() >= sizeof address.sun_path)
    return tl::unexpected{std::string{path} + ": too long for a socket: " + std::to_string(path.size()) +
                          " bytes, at most " + std::to_string(sizeof address.sun_path - 1)};
  std::copy(path.begin(), path.end(), address.sun_path);
  return address;
}

}  // namespace control
