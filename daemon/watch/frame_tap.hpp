#pragma once

#include <cstdint>

#include "daemon/watch/listeners.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"

namespace axisd {

/// Which way a frame goes, as the unit sees it.
enum class Direction : std::uint8_t { Received, Sent };

/// Who hears the frames of a unit, on the unit's thread.
class FrameListener {
 public:
  virtual ~FrameListener() = default;
  /// @p frame has come, or the unit has handed it over to be sent, at @p time. What was received is told before
  /// the unit takes it, what it answers after that.
  virtual void on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept = 0;
  /// The unit has finished with the frames and the time that were told last: its state is that of @p now.
  virtual void on_handled(canopen::TimePoint now) noexcept { (void)now; }
  /// When on_handled() is wanted though nothing comes; kNever: not at all.
  virtual canopen::TimePoint next_deadline() const noexcept { return canopen::kNever; }
};

/// Who puts a tap into the way of the frames and takes it out.
class TapOwner {
 public:
  virtual ~TapOwner() = default;
  /// Somebody listens from now on, or nobody does.
  virtual void on_tap(bool is_open) noexcept = 0;
};

/// Where the frames of a unit can be heard, both ways. While nobody listens, it is not in their way at all.
class FrameTap final : public canopen::FrameSink {
 public:
  /// Frames go on to @p bus; both arguments outlive this.
  FrameTap(canopen::FrameSink& bus, TapOwner& owner) noexcept : bus_{bus}, owner_{owner} {}
  ~FrameTap() override = default;
  FrameTap(const FrameTap&) = delete;
  FrameTap& operator=(const FrameTap&) = delete;

  /// False if there are too many listeners. Neither from within a call to a listener.
  [[nodiscard]] bool add(FrameListener& listener) noexcept;
  void remove(FrameListener& listener) noexcept;

  /// @p frame has come at @p now; on_handled() follows.
  void on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept;
  /// The unit is about to be told the time; on_handled() follows.
  void on_time(canopen::TimePoint now) noexcept { told_ = now_ = now; }
  void on_handled() noexcept;
  /// A frame that the unit sends: heard, and handed on.
  void send(const canopen::Frame& frame, canopen::Delivery delivery) override;
  /// The time that holds for what happens now: that which the unit is being told, or else the present. It does not
  /// go back.
  canopen::TimePoint now() const noexcept;
  /// The earliest deadline of the listeners.
  canopen::TimePoint next_deadline() const noexcept;

 private:
  void tell(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept;

  canopen::FrameSink& bus_;
  TapOwner& owner_;
  Listeners<FrameListener> listeners_;
  canopen::TimePoint now_ = canopen::kNever;  ///< kNever: what the unit does now has another cause
  canopen::TimePoint told_{};                 ///< the last one
};

}  // namespace axisd
