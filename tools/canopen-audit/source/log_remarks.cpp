#include "tools/canopen-audit/source/log_remarks.hpp"

#include <fmt/format.h>

#include "tools/canopen-audit/source/in_order.hpp"

namespace audit_tool {
namespace {

using namespace std::chrono_literals;

/// Damaged lines that are said; of further ones the number.
constexpr std::size_t kMostSaid = 5;
/// A bus of a master is rarely silent for longer.
constexpr std::chrono::nanoseconds kGap = 2s;

std::string times_more(std::uint64_t count) {
  return count == 1 ? std::string{} : fmt::format(", and {} times more", count - 1);
}

}  // namespace

void LogRemarks::take_damaged(const std::string& message) {
  if (++damages_ <= kMostSaid) damaged_.push_back(message + ": left out, a finding may come of that");
}

void LogRemarks::take(const runs::LoggedFrame& logged) {
  const std::chrono::nanoseconds silence = frames_++ == 0 ? 0ns : logged.at - last_;
  if (silence < 0ns && silence >= -InOrder::kWindow) return;
  last_ = logged.at;
  if (silence < 0ns && backward_++ == 0) backward_place_ = logged.place;
  if (silence > kGap) ++gaps_;
  if (silence <= longest_) return;
  longest_ = silence;
  longest_place_ = logged.place;
}

std::vector<std::string> LogRemarks::lines(const runs::LogReader& log) const {
  std::vector<std::string> lines;
  add_damage(log, lines);
  if (log.has_times() || frames_ == 0)
    add_times(log.path(), lines);
  else
    lines.push_back(log.path() + ": the log has no time stamps: rules of time are not judged");
  return lines;
}

void LogRemarks::add_damage(const runs::LogReader& log, std::vector<std::string>& lines) const {
  lines = damaged_;
  if (damages_ > kMostSaid) lines.push_back(fmt::format("{}: {} damaged lines in all", log.path(), damages_));
  if (!log.remark().empty()) lines.push_back(log.remark());
  if (log.lost() > 0)
    lines.push_back(fmt::format("{}: {} records are missing: a finding may come of that", log.path(), log.lost()));
}

void LogRemarks::add_times(const std::string& path, std::vector<std::string>& lines) const {
  if (gaps_ > 0)
    lines.push_back(
        fmt::format("{}:{}: no frame for {:.3f} s before here{}: a finding may come of frames that are missing",
                    path, longest_place_, std::chrono::duration<double>{longest_}.count(),
                    gaps_ == 1 ? "" : fmt::format(", the longest of {} gaps", gaps_)));
  if (backward_ > 0)
    lines.push_back(fmt::format("{}:{}: the time goes back here{}: times are counted on from the frame before",
                                path, backward_place_, times_more(backward_)));
}

}  // namespace audit_tool
