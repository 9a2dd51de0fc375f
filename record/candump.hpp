#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include <linux/can.h>
#include <tl/expected.hpp>

#include "libcanopen/base/frame.hpp"

namespace record {

/// A line of a log of candump.
struct CandumpLine {
  std::chrono::nanoseconds at{};  ///< since 1970
  std::string_view interface;     ///< part of the line if it was read
  can_frame frame{};              ///< identifier with its flags; of a remote frame no data
};

/// @p line as `candump -l` writes it, which canplayer and others read: "(1700000000.123456) can0 605#40...", and
/// an end of line. Error frames have eight digits with the error flag among them.
[[nodiscard]] std::string candump_line(const CandumpLine& line);
/// The same of a frame without an error flag.
[[nodiscard]] std::string candump_line(const canopen::Frame& frame, std::chrono::nanoseconds wall_clock,
                                       std::string_view interface);

/// Reads @p text, a line without its end; blanks around it do not count. The error says what was expected.
[[nodiscard]] tl::expected<CandumpLine, std::string_view> read_candump_line(std::string_view text) noexcept;

/// A line of what candump prints.
struct PrintedLine {
  CandumpLine line{};
  bool has_time = true;  ///< else `at` means nothing
};
/// Reads @p text as candump prints it on a terminal, "(1700000000.123456)  can0  605   [8]  40 00 10 ...", with or
/// without time (-t a, -t z), direction (-x) and letters (-a), or as `candump -l` writes it. The error says what
/// was expected.
[[nodiscard]] tl::expected<PrintedLine, std::string_view> read_printed_line(std::string_view text) noexcept;

}  // namespace record
