#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string_view>

namespace canrec {

/// Reads a time of more than 0, `90`, `90s`, `15m`, `12h` or `7d`.
[[nodiscard]] std::optional<std::chrono::nanoseconds> read_age(std::string_view text) noexcept;

/// Reads a number of bytes, `500000`, `500k`, `100M` or `2G` (powers of 1024).
[[nodiscard]] std::optional<std::int64_t> read_bytes(std::string_view text) noexcept;

/// Reads how many times as fast a log is played: a number of more than 0, up to a million.
[[nodiscard]] std::optional<double> read_speed(std::string_view text) noexcept;

}  // namespace canrec
