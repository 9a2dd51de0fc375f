#pragma once

#include <array>
#include <coroutine>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <string_view>

#include "can/hub/medium/medium.hpp"
#include "libcanopen/base/frame.hpp"
#include "libcanopen/base/time.hpp"
#include "sim/base/draw.hpp"

namespace sim {

/// A program on the bus that is no unit: it hears all frames, some time after they were there, and what it does
/// next waits for a frame or for a time.
class Station : private hub::Participant {
 public:
  /// At @p medium under @p name, which outlive this; @p draw decides how quick it is.
  Station(hub::Medium& medium, std::string_view name, Draw draw);
  ~Station() override;

  /// Whether a frame is the one that is waited for.
  using Fits = std::function<bool(const canopen::Frame&)>;

  /// Waits until a frame comes that fits, @p until the latest; true: it has come.
  class Wait {
   public:
    Wait(Station& station, const Fits* fits, canopen::TimePoint until) noexcept
        : station_{station}, fits_{fits}, until_{until} {}
    bool await_ready() const noexcept { return false; }
    void await_suspend(std::coroutine_handle<> waiting);
    bool await_resume() const noexcept { return has_come_; }

   private:
    friend class Station;
    Station& station_;
    const Fits* fits_;  ///< nullptr: none does
    canopen::TimePoint until_;
    std::coroutine_handle<> waiting_{};
    bool has_come_ = false;
  };
  /// @p fits outlives the wait.
  [[nodiscard]] Wait wait_for(const Fits& fits, canopen::Duration longest) noexcept {
    return {*this, &fits, now_ + longest};
  }
  [[nodiscard]] Wait sleep(canopen::Duration duration) noexcept { return {*this, nullptr, now_ + duration}; }

  /// Puts @p frame on the bus; what finds no room is lost, as with a master that does not look.
  void send(const canopen::Frame& frame) noexcept;

  /// Time of its present.
  [[nodiscard]] canopen::TimePoint now() const noexcept { return now_; }
  [[nodiscard]] Draw& draw() noexcept { return draw_; }
  /// When turn() is wanted.
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept;
  /// It is @p now: hears what has come by then, and goes on with what has waited for it.
  void turn(canopen::TimePoint now);
  /// It does nothing until @p until, as a program that is stopped.
  void stall(canopen::TimePoint until) noexcept { stalled_until_ = until; }

 protected:
  /// Every frame that is heard, before those who wait.
  virtual void on_frame(const canopen::Frame& frame) noexcept { static_cast<void>(frame); }

 private:
  struct Heard {
    canopen::Frame frame;
    canopen::TimePoint at;
  };
  // hub::Participant
  void receive(const hub::Passage& passage) noexcept override;
  [[nodiscard]] hub::Identity identity() const noexcept override { return identity_; }

  void hear(const canopen::Frame& frame);
  canopen::TimePoint earliest() const noexcept;

  hub::Medium& medium_;
  hub::Identity identity_;
  Draw draw_;
  canopen::TimePoint now_;
  canopen::TimePoint stalled_until_{};
  std::deque<Heard> heard_;
  std::list<Wait*> waits_;
  canopen::TimePoint due_ = canopen::kNever;  ///< earliest() of these two
};

}  // namespace sim
