#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace farm {

/// What is said of a bus: the value of a key of the bucket of buses.
struct BusSettings {
  std::uint32_t bit_rate = 0;  ///< bit/s; 0: frames take no time

  friend bool operator==(const BusSettings&, const BusSettings&) = default;
};

/// What is said of a host: the value of a key of the bucket of hosts.
struct HostSettings {
  bool drain = false;  ///< it gives its units away, and takes none

  friend bool operator==(const HostSettings&, const HostSettings&) = default;
};

/// Read @p text, the value of @p key; the error is one line.
[[nodiscard]] tl::expected<BusSettings, std::string> parse_bus_settings(std::string_view key,
                                                                        std::string_view text);
[[nodiscard]] tl::expected<HostSettings, std::string> parse_host_settings(std::string_view key,
                                                                          std::string_view text);
[[nodiscard]] std::string text_of(const BusSettings& settings);
[[nodiscard]] std::string text_of(const HostSettings& settings);

}  // namespace farm
