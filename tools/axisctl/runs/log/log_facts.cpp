#include "tools/axisctl/runs/log/log_facts.hpp"

#include <fmt/format.h>

#include "can/hub/medium/bit_time.hpp"
#include "can/port/wire.hpp"
#include "libcanopen/base/cob_id.hpp"

namespace runs {
namespace {

using namespace std::chrono_literals;
namespace function_code = canopen::function_code;

/// A bus of a master is rarely silent for longer.
constexpr std::chrono::nanoseconds kGap = 2s;
/// The load is reckoned over that long at least; adapters hand frames over in heaps that are shorter.
constexpr std::chrono::nanoseconds kLoadWindow = 50ms;
/// Frames in the window; twice what 1 Mbit/s can carry.
constexpr std::size_t kMostInWindow = 2048;
/// By which a time stamp may be wrong before a log is said to be of another bit rate.
constexpr double kLoadSlack = 1.05;
constexpr std::uint32_t kNodes = 0x7F;
constexpr double kKilo = 1000;

double seconds_of(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>{time}.count();
}

}  // namespace

void LogFacts::take(const LoggedFrame& logged) {
  const canopen::Frame& frame = logged.frame;
  const std::uint32_t function = frame.id & ~kNodes, node = frame.id & kNodes;
  const bool is_boot_up =
      function == function_code::kErrorControl && !frame.remote && frame.length == 1 && frame.data[0] == 0;
  if (!logged.is_error && !frame.extended && (function == function_code::kSdoResponse || is_boot_up))
    nodes_.set(node);
  if (frames_++ > 0) take_time(logged);
  last_ = logged.at;
  take_load(logged);
}

void LogFacts::take_time(const LoggedFrame& logged) {
  const std::chrono::nanoseconds silence = logged.at - last_;
  if (silence == 0ns) ++same_;
  if (silence < 0ns && backward_++ == 0) backward_place_ = logged.place;
  if (silence > kGap) ++gaps_;
  if (silence <= longest_) return;
  longest_ = silence;
  longest_place_ = logged.place;
}

void LogFacts::take_load(const LoggedFrame& logged) {
  if (logged.is_error) return;
  const unsigned bits = hub::bits_on_wire(bus::to_wire(logged.frame));
  if (!window_.empty()) bits_ += bits;
  window_.push_back({logged.at, bits});
  while (window_.size() > 2 && (logged.at - window_[1].at >= kLoadWindow || window_.size() > kMostInWindow)) {
    window_.pop_front();
    bits_ -= window_.front().bits;
  }
  const std::chrono::nanoseconds length = logged.at - window_.front().at;
  if (length < kLoadWindow) return;
  const double load = static_cast<double>(bits_) / seconds_of(length);
  if (load <= densest_) return;
  densest_ = load;
  densest_place_ = logged.place;
}

std::vector<std::string> LogFacts::remarks(const LogReader& log, std::uint32_t bit_rate) const {
  std::vector<std::string> remarks;
  const std::string& path = log.path();
  if (log.lost() > 0) remarks.push_back(fmt::format("{}: {} records are missing", path, log.lost()));
  if (!log.has_times()) {
    remarks.push_back(
        fmt::format("{}: the log has no time stamps: each frame goes out behind the answers to those "
                    "before it, and no time is compared",
                    path));
    return remarks;
  }
  if (gaps_ > 0)
    remarks.push_back(
        fmt::format("{}:{}: {} of more than {} s without a frame, the longest of {:.3f} s before here", path,
                    longest_place_, gaps_ == 1 ? "a gap" : fmt::format("{} gaps", gaps_),
                    std::chrono::duration_cast<std::chrono::seconds>(kGap).count(), seconds_of(longest_)));
  if (same_ > 0)
    remarks.push_back(
        fmt::format("{}: {} of {} frames have the time stamp of the frame before", path, same_, frames_));
  if (backward_ > 0)
    remarks.push_back(
        fmt::format("{}:{}: the time goes back here{}: such frames go out right behind the one before", path,
                    backward_place_, backward_ == 1 ? "" : fmt::format(", and {} times more", backward_ - 1)));
  if (bit_rate != 0 && densest_ > bit_rate * kLoadSlack)
    remarks.push_back(
        fmt::format("{}:{}: the frames before here take {:.0f} kbit/s, more than the {:.0f} kbit/s of "
                    "the bus: the log is of another bit rate",
                    path, densest_place_, densest_ / kKilo, bit_rate / kKilo));
  return remarks;
}

Expected<LogFacts> check_log(const std::string& path, const std::string& interface, std::uint32_t bit_rate,
                             std::vector<std::string>& remarks) {
  auto log = LogReader::open(path, interface);
  if (!log) return tl::unexpected{log.error()};
  LogFacts facts;
  for (;;) {
    const auto frame = (*log)->next();
    if (!frame) return tl::unexpected{frame.error()};
    if (!*frame) break;
    facts.take(**frame);
  }
  if (facts.frames() == 0) return fail(ExitStatus::Damaged, fmt::format("{}: there is no frame in it", path));
  if (!(*log)->remark().empty()) remarks.push_back((*log)->remark());
  for (std::string& remark : facts.remarks(**log, bit_rate)) remarks.push_back(std::move(remark));
  return facts;
}

}  // namespace runs
