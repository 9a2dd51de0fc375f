#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "trace/event.hpp"
#include "trace/frame.hpp"
#include "trace/signal/signal.hpp"
#include "trace/timed_ring.hpp"

namespace trace {

/// How much a recording takes.
struct RecordingSize {
  std::size_t signals;
  std::size_t samples;
  std::size_t before;  ///< samples before the trigger
};

/// Samples of some signals with the frames and events of the same time. It is a ring until the trigger comes, and
/// full with the samples that follow it. Nothing is allocated after construction.
class Recording {
 public:
  static constexpr std::size_t kMostFrames = 8192;
  static constexpr std::size_t kMostEvents = 512;

  explicit Recording(const RecordingSize& size)
      : size_{size},
        times_(size.samples),
        values_(size.samples * size.signals),
        frames_{kMostFrames},
        events_{kMostEvents} {}

  /// Begins as recording @p number.
  void begin(std::uint64_t number) noexcept;
  /// The trigger has come at @p time: of the samples before it as many stay as were wanted.
  void trigger(unit::TimePoint time) noexcept;
  /// Takes what the signals of @p readers are at @p time.
  void sample(unit::TimePoint time, std::span<const Reader> readers) noexcept;
  void add(const Frame& frame) noexcept { keep(frames_, frame); }
  void add(const Event& event) noexcept { keep(events_, event); }
  /// No sample follows: frames and events outside the window are forgotten.
  void end() noexcept;

  /// Whether the trigger was there and all samples behind it are.
  bool is_full() const noexcept { return triggered_ && remaining_ == 0; }
  std::uint64_t number() const noexcept { return number_; }
  std::optional<unit::TimePoint> trigger_time() const noexcept { return triggered_; }
  std::size_t size() const noexcept { return count_; }
  std::size_t signals() const noexcept { return size_.signals; }
  /// Sample @p position, 0 = the oldest.
  unit::TimePoint time(std::size_t position) const noexcept { return times_[slot(position)]; }
  std::span<const double> values(std::size_t position) const noexcept {
    return {values_.data() + slot(position) * size_.signals, size_.signals};
  }
  const TimedRing<Frame>& frames() const noexcept { return frames_; }
  const TimedRing<Event>& events() const noexcept { return events_; }

 private:
  template <class Item>
  void keep(TimedRing<Item>& ring, const Item& item) noexcept {
    if (!triggered_) return ring.push(item);
    if (ring.is_full() && count_ > 0) ring.forget_before(time(0));
    ring.push_if_room(item);
  }
  std::size_t slot(std::size_t position) const noexcept { return (first_ + position) % size_.samples; }
  void drop_oldest() noexcept {
    dropped_ = true;
    first_ = (first_ + 1) % size_.samples;
    --count_;
  }

  RecordingSize size_;
  std::vector<unit::TimePoint> times_;
  std::vector<double> values_;  ///< a row a sample
  TimedRing<Frame> frames_;
  TimedRing<Event> events_;
  std::uint64_t number_ = 0;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  bool dropped_ = false;       ///< there were samples before the oldest
  std::size_t remaining_ = 0;  ///< samples to come behind the trigger
  std::optional<unit::TimePoint> triggered_{};
};

}  // namespace trace
