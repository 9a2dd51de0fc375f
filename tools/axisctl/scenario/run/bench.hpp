#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "can/clock/sleeper.hpp"
#include "can/connection/connection.hpp"
#include "tools/canopen-check/core/wire.hpp"

namespace scenario {

using conformance::TimedFrame;

/// The bus of a run: every frame is kept, cyclic frames are sent, and between frames somebody looks around.
/// Whoever waits, waits here.
class Bench final : public conformance::Wire {
 public:
  /// Looks around; false: the run is to end.
  using Look = std::function<bool()>;

  /// Lives by @p time, which outlives it; nullptr: the machine's.
  explicit Bench(bus::Connection connection, bus::TimeShare* time = nullptr);

  void on_look(Look look) { look_ = std::move(look); }

  bool send(const canopen::Frame& frame) override;
  std::optional<TimedFrame> receive(canopen::TimePoint until) override;
  canopen::TimePoint now() override;
  bool up() const override { return up_; }
  bool interrupted() const override { return ended_; }

  /// Lets time pass until @p until, or until the run is to end.
  void pass(canopen::TimePoint until);
  /// The same, but comes back after any frame or look.
  void wait(canopen::TimePoint until);

  void start_cyclic(const std::string& name, const canopen::Frame& frame, canopen::Duration period);
  void stop_cyclic(const std::string& name) { cyclic_.erase(name); }

  /// All frames so far, those of this program included.
  [[nodiscard]] const std::vector<TimedFrame>& frames() const noexcept { return frames_; }

 private:
  struct Cyclic {
    canopen::Frame frame{};
    canopen::Duration period{};
    canopen::TimePoint next{};
  };
  std::optional<TimedFrame> take();
  /// Sends what is due; when the next is.
  canopen::TimePoint serve_cyclic();
  bool look();

  bus::Connection connection_;
  bus::Sleeper sleeper_;
  Look look_{};
  std::map<std::string, Cyclic> cyclic_;
  std::vector<TimedFrame> frames_;
  canopen::TimePoint next_look_{};
  bool up_ = true, ended_ = false;
};

/// From now on SIGINT and SIGTERM end the run instead of the program.
void take_signals();
/// The signal that has come, 0: none.
[[nodiscard]] int taken_signal() noexcept;

}  // namespace scenario
