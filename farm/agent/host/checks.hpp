#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "farm/agent/host/outcomes.hpp"
#include "farm/agent/process/short_run.hpp"
#include "farm/agent/unit/unit_folder.hpp"

namespace farm::agent {

/// Configurations that axisd judges, by `axisd --check-config`. One that it has found good is good for other
/// units, too.
class Checks {
 public:
  /// At the same time.
  static constexpr std::size_t kMost = 2;

  /// @p axisd is the path of the program; @p events, @p folders and @p outcomes outlive this.
  Checks(axisd::ServiceEvents& events, const Folders& folders, std::string axisd, Outcomes& outcomes)
      : events_{events}, folders_{folders}, axisd_{std::move(axisd)}, outcomes_{outcomes} {}

  /// Has @p check judged; its outcome is told later.
  void judge(Check check);

 private:
  void begin_next();
  void begin(const Check& check);
  void finish(const Check& check, const ProcessEnd& end, std::string_view output, const std::string& path);

  axisd::ServiceEvents& events_;
  const Folders& folders_;
  std::string axisd_;
  Outcomes& outcomes_;
  std::deque<Check> waiting_;
  std::uint64_t last_number_ = 0;
  std::map<std::uint64_t, std::unique_ptr<ShortRun>> runs_;
  std::set<std::string> good_;  ///< configurations
};

/// What `axisd --check-config` has said of the file at @p path, as a problem: one line without the names of the
/// program and of the file. Empty if it has said nothing.
[[nodiscard]] std::string problem_of_check(std::string_view output, std::string_view path);

}  // namespace farm::agent
