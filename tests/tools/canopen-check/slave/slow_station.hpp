#pragma once

#include <utility>
#include <vector>

#include "tools/canopen-zoo/slave/station.hpp"

namespace conformance_test {

/// How long a slave takes; what it hears it takes in the order in which it comes.
struct Slowness {
  canopen::Duration sdo{};     ///< until it takes an SDO request
  canopen::Duration others{};  ///< until it takes another frame
  canopen::Duration out{};     ///< until a frame that is no SDO answer leaves
  bool one_upload = false;     ///< an upload that is asked for while another one waits gets lost
  canopen::Duration tick{};    ///< of the task that looks at its timers; 0: they are looked at when they are due
};

/// A slave with node-ID 5 that is right, but slow.
class SlowStation final : public zoo::Station {
 public:
  /// @p slave must outlive it.
  SlowStation(zoo::Station& slave, const Slowness& slowness) : slave_{&slave}, slowness_{slowness} {}

  void on_frame(const canopen::Frame& frame, canopen::TimePoint now) override;
  void on_time(canopen::TimePoint now) override;
  canopen::TimePoint next_deadline() const override;
  std::vector<canopen::Frame> take_frames() override { return std::exchange(sent_, {}); }
  /// Uploads that were asked for while another one waited.
  [[nodiscard]] std::size_t overlapping() const noexcept { return overlapping_; }

 private:
  struct Due {
    canopen::TimePoint time;
    canopen::Frame frame;
  };
  /// Puts @p frame behind those that are due before it or at the same time.
  static void insert(std::vector<Due>& queue, canopen::TimePoint time, const canopen::Frame& frame);
  /// What waits longest in @p queue, if it is due at @p now.
  static bool take(std::vector<Due>& queue, canopen::TimePoint now, Due& due);
  void collect(canopen::TimePoint now);
  /// When the slave looks at its timers next.
  [[nodiscard]] canopen::TimePoint next_look() const;

  zoo::Station* slave_;
  Slowness slowness_;
  std::vector<Due> incoming_, outgoing_;
  std::vector<canopen::Frame> sent_;
  std::size_t overlapping_ = 0;
};

}  // namespace conformance_test
