#include "farm/agent/host/checks.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <unistd.h>

#include "control/socket_name.hpp"

namespace farm::agent {
namespace {

/// Configurations that are remembered.
constexpr std::size_t kMostGood = 256;

/// Whether what is good for one unit of the kind is good for @p unit: its name says more than the node-ID.
bool is_like_others(const UnitName& unit) noexcept {
  return !control::is_unconfigured(unit.node);
}

}  // namespace

void Checks::judge(Check check) {
  waiting_.push_back(std::move(check));
  begin_next();
}

void Checks::begin_next() {
  while (!waiting_.empty() && runs_.size() < kMost) {
    const Check check = std::move(waiting_.front());
    waiting_.pop_front();
    begin(check);
  }
}

void Checks::begin(const Check& check) {
  if (is_like_others(check.unit) && good_.contains(check.configuration)) return outcomes_.on_judged(check, {});
  const std::string path = folders_.configuration(check.unit) + ".check";
  const auto content = configuration_file(folders_, check.unit, check.configuration);
  if (!content) return outcomes_.on_judged(check, content.error());
  if (const auto written = replace_file(path, *content); !written)
    return outcomes_.on_not_judged(check, written.error());
  const std::uint64_t number = ++last_number_;
  runs_[number] =
      std::make_unique<ShortRun>(events_, std::vector<std::string>{axisd_, "--check-config", "--config", path},
                                 [this, number, check, path](const ProcessEnd& end, const std::string& output) {
                                   runs_.erase(number);
                                   ::unlink(path.c_str());
                                   finish(check, end, output, path);
                                 });
}

/// One that has failed without a word about the file has not judged it.
void Checks::finish(const Check& check, const ProcessEnd& end, std::string_view output, const std::string& path) {
  const std::string problem = end.is_good ? "" : problem_of_check(output, path);
  if (end.is_good) {
    if (good_.size() >= kMostGood) good_.clear();
    good_.insert(check.configuration);
  }
  if (end.is_good || !problem.empty())
    outcomes_.on_judged(check, problem);
  else
    outcomes_.on_not_judged(check,
                            fmt::format("the configuration cannot be judged: axisd --check-config: {}", end.how));
  begin_next();
}

std::string problem_of_check(std::string_view output, std::string_view path) {
  std::string_view line = output.substr(0, output.find('\n'));
  for (const std::string& start : {std::string{"axisd: "}, fmt::format("{}: ", path)})
    if (line.starts_with(start)) line.remove_prefix(start.size());
  if (line.empty()) return {};
  return fmt::format("configuration: {}", line);
}

}  // namespace farm::agent
