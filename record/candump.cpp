#include "record/candump.hpp"

#include <iterator>

#include <fmt/format.h>

namespace record {

std::string candump_line(const canopen::Frame& frame, std::chrono::nanoseconds wall_clock,
                         std::string_view interface) {
  const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(wall_clock).count();
  constexpr std::int64_t kSecond = 1'000'000;
  std::string line = fmt::format("({:010}.{:06}) {} ", microseconds / kSecond, microseconds % kSecond, interface);
  const auto end = std::back_inserter(line);
  if (frame.extended) {
    fmt::format_to(end, "{:08X}#", frame.id);
  } else {
    fmt::format_to(end, "{:03X}#", frame.id);
  }
  if (frame.remote) {
    fmt::format_to(end, "R{}", frame.length);
  } else {
    for (std::size_t i = 0; i < frame.length; ++i) fmt::format_to(end, "{:02X}", frame.data[i]);
  }
  line += '\n';
  return line;
}

}  // namespace record
