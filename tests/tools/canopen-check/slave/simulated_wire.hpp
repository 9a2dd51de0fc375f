#pragma once

#include <deque>
#include <vector>

#include "tools/canopen-check/core/wire.hpp"
#include "tools/canopen-zoo/slave/station.hpp"

namespace conformance_test {

/// A bus of simulated nodes in simulated time: hours pass in milliseconds, and every run is the same.
class SimulatedWire final : public conformance::Wire {
 public:
  /// Puts @p station on the bus; it must outlive it.
  void add(zoo::Station& station) { stations_.push_back(&station); }
  /// Takes every station off the bus once @p frames have been sent to them.
  void lose_nodes_after(std::size_t frames) { frames_until_loss_ = frames; }
  /// The bus goes down once @p frames have been sent.
  void go_down_after(std::size_t frames) { frames_until_down_ = frames; }
  /// The user interrupts once @p frames have been sent.
  void interrupt_after(std::size_t frames) { frames_until_interrupt_ = frames; }
  /// Frames that the tester has sent.
  [[nodiscard]] std::size_t sent() const noexcept { return sent_; }

  bool send(const canopen::Frame& frame) override;
  std::optional<conformance::TimedFrame> receive(canopen::TimePoint until) override;
  canopen::TimePoint now() override { return now_; }
  bool up() const override { return sent_ < frames_until_down_; }
  bool interrupted() const override { return sent_ >= frames_until_interrupt_; }

 private:
  /// A frame takes the bus that long: about that of eight bytes at 1 Mbit/s.
  static constexpr canopen::Duration kFrameTime = std::chrono::microseconds{100};
  static constexpr std::size_t kNeverHappens = static_cast<std::size_t>(-1);

  void collect();

  canopen::TimePoint now_{std::chrono::hours{1}};
  std::vector<zoo::Station*> stations_;
  std::deque<conformance::TimedFrame> waiting_;
  std::size_t sent_ = 0;
  std::size_t frames_until_loss_ = kNeverHappens;
  std::size_t frames_until_down_ = kNeverHappens;
  std::size_t frames_until_interrupt_ = kNeverHappens;
};

}  // namespace conformance_test
