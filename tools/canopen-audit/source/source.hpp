#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "audit/auditor.hpp"
#include "tools/canopen-audit/command_line/options.hpp"

namespace audit_tool {

/// What was heard.
struct Hearing {
  std::unique_ptr<audit::Auditor> auditor{};  ///< who has judged it
  canopen::Duration begin{}, end{};           ///< of the first and the last frame
  bool has_times = true;
  std::string_view place_word = "frame";  ///< what the places of its frames count: lines, records, frames
  std::vector<std::string> remarks{};     ///< what is to be said of it, a line each: gaps, damaged lines
  std::string problem{};                  ///< why it could not begin, or has ended too early; else empty
};

/// Hears the log that @p options name, from end to end. A damaged line is said and left out. UsageError if it
/// cannot be read.
[[nodiscard]] Hearing hear_log(const Options& options, audit::Circumstances circumstances);
/// Hears the bus until a signal comes or the time of @p options is over. On a terminal it says each second how
/// many rules are broken.
[[nodiscard]] Hearing hear_bus(const Options& options, audit::Circumstances circumstances);

}  // namespace audit_tool
