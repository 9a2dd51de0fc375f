#pragma once

#include <mutex>
#include <string>

#include "tests/can/hub/running_hub.hpp"

namespace hub_test {

/// A hub with virtual or stepped time at 1 Mbit/s, in a thread of the test.
class HubWithTurns {
 public:
  explicit HubWithTurns(userbus::TimeMode mode = userbus::TimeMode::Virtual,
                        canopen::Duration silence = std::chrono::minutes{1})
      : hub_{{.bit_rate = 1'000'000,
              .time = {mode, 1},
              .turns = {.silence = silence, .notice = [this](std::string_view line) {
                          const std::lock_guard lock{mutex_};
                          notices_ += std::string{line} + '\n';
                        }}}} {}

  [[nodiscard]] std::string path() const { return hub_.path(); }
  /// Lines for the operator.
  [[nodiscard]] std::string notices() {
    const std::lock_guard lock{mutex_};
    return notices_;
  }

 private:
  std::mutex mutex_;
  std::string notices_;
  RunningHub hub_;
};

}  // namespace hub_test
