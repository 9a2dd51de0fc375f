#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/axisctl/runs/log/log_reader.hpp"

namespace audit_tool {

/// What is to be said of a log, so that its reader knows how far the findings can be trusted.
class LogRemarks {
 public:
  /// A line of the log that is left out, and why.
  void take_damaged(const std::string& message);
  /// The next frame, with the time that the log has for it.
  void take(const runs::LoggedFrame& logged);

  /// All of @p log, a line each.
  [[nodiscard]] std::vector<std::string> lines(const runs::LogReader& log) const;

 private:
  void add_damage(const runs::LogReader& log, std::vector<std::string>& lines) const;
  void add_times(const std::string& path, std::vector<std::string>& lines) const;

  std::vector<std::string> damaged_{};  ///< the first ones
  std::uint64_t damages_ = 0, frames_ = 0, gaps_ = 0, backward_ = 0;
  std::uint64_t longest_place_ = 0, backward_place_ = 0;
  std::chrono::nanoseconds last_{}, longest_{};
};

}  // namespace audit_tool
