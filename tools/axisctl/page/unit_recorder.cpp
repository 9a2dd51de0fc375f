#include "tools/axisctl/page/unit_recorder.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include "os/clock.hpp"
#include "record/format.hpp"

namespace axisctl {
namespace {

using nlohmann::json;
using std::chrono::nanoseconds;
using std::chrono::steady_clock;

constexpr std::array<std::string_view, 4> kSignalsOfAxis{"speed", "speed_setpoint", "torque", "current"};
/// Most that the files of the recording take (MB): it fits into a page.
constexpr int kMostMB = 40;
/// Patience with the rest of a recording, of which at most a MiB waits for the disk.
constexpr std::chrono::seconds kPatience{10};
constexpr std::chrono::milliseconds kAskAgain{10};

/// Keeps SIGINT and SIGTERM from ending the program while it is there.
class HeldSignals {
 public:
  HeldSignals() {
    ::sigemptyset(&held_);
    for (const int signal : {SIGINT, SIGTERM}) ::sigaddset(&held_, signal);
    ::sigprocmask(SIG_BLOCK, &held_, &before_);
  }
  ~HeldSignals() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  /// Waits for one of them, for at most @p length.
  void wait(nanoseconds length) const {
    const auto until = steady_clock::now() + length;
    while (true) {
      const nanoseconds left = std::max<nanoseconds>(until - steady_clock::now(), nanoseconds{0});
      const timespec limit = os::to_timespec(left);
      if (::sigtimedwait(&held_, nullptr, &limit) >= 0 || errno != EINTR) return;
    }
  }

 private:
  sigset_t held_{}, before_{};
};

/// No other recording has it: that of a former one would keep the older half.
std::string new_name() {
  return fmt::format("page-{:%Y%m%d-%H%M%S}-{}", fmt::gmtime(std::time(nullptr)), ::getpid());
}

}  // namespace

std::vector<std::string> default_signals(std::size_t axes) {
  std::vector<std::string> signals;
  for (std::size_t axis = 1; axis <= axes; ++axis)
    for (const std::string_view signal : kSignalsOfAxis)
      if (signals.size() < record::kMostSignals) signals.push_back(fmt::format("{}/{}", axis, signal));
  return signals;
}

Expected<void> record_unit(const Ask& ask, const RecordingWish& wish) {
  json params{{"name", new_name()}, {"max_MB", kMostMB}, {"signals", wish.signals}};
  if (wish.signals.empty()) {
    const auto status = ask("status", json::object());
    if (!status) return tl::unexpected{status.error()};
    params["signals"] = default_signals(status->value("axes", json::array()).size());
  }
  if (wish.every_s) params["every_s"] = *wish.every_s;
  const HeldSignals signals;
  if (const auto begun = ask("record.start", params); !begun) return tl::unexpected{begun.error()};
  signals.wait(wish.length);
  const auto ended = ask("record.stop", json::object());
  if (!ended) return tl::unexpected{ended.error()};
  return {};
}

Expected<std::string> written_file(const Ask& ask) {
  const auto until = steady_clock::now() + kPatience;
  while (true) {
    const auto status = ask("record.status", json::object());
    if (!status) return tl::unexpected{status.error()};
    const std::string state = status->value("state", "");
    if (state == "stopped" || state == "off") return status->value("file", "");
    if (state == "failed") return fail(ExitStatus::Failed, "the recording: " + status->value("error", "failed"));
    if (steady_clock::now() > until)
      return fail(ExitStatus::TimedOut,
                  fmt::format("the recording is not written within {} s", kPatience.count()));
    std::this_thread::sleep_for(kAskAgain);
  }
}

}  // namespace axisctl
