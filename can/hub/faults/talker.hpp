#pragma once

#include <cstddef>
#include <cstdint>

#include <linux/can.h>

#include "can/hub/medium/medium.hpp"
#include "injection/language/trigger.hpp"

namespace hub::faults {

/// Sends the same frame again and again, as long as a fault has it do so: every frame is an opportunity. Takes
/// part in the medium until its end, and takes then back what waits still.
class Talker : public Participant {
 public:
  /// @p trigger outlives this.
  Talker(Medium& medium, injection::Trigger& trigger, const can_frame& frame);
  Talker(const Talker&) = delete;
  Talker& operator=(const Talker&) = delete;
  ~Talker() override;

  /// Begins at @p now.
  void start(canopen::TimePoint now) noexcept;
  [[nodiscard]] bool is_started() const noexcept { return started_; }
  /// When on_time() is wanted.
  [[nodiscard]] canopen::TimePoint next_deadline() const noexcept;
  void on_time(canopen::TimePoint now) noexcept;
  /// A frame, perhaps of its own, has come to its end at @p end.
  virtual void on_frame(const Passage&, canopen::TimePoint) noexcept {}
  void receive(const Passage& passage) noexcept override;

 protected:
  /// An opportunity; true if it was hit. Without room for the frame there is none.
  bool speak(canopen::TimePoint now) noexcept;
  [[nodiscard]] bool has_room() const noexcept { return waiting_ < Medium::kQueue; }
  [[nodiscard]] Medium& medium() const noexcept { return medium_; }
  /// Time of one frame; 0 where frames take none.
  [[nodiscard]] canopen::Duration frame_time() const noexcept;
  [[nodiscard]] bool is_over() const noexcept { return trigger_.phase() == injection::Phase::Over; }

 private:
  virtual void begin(canopen::TimePoint now) noexcept = 0;
  [[nodiscard]] virtual canopen::TimePoint wanted() const noexcept = 0;
  /// Sends what is due at @p now.
  virtual void go_on(canopen::TimePoint now) noexcept = 0;

  Medium& medium_;
  injection::Trigger& trigger_;
  can_frame frame_;
  std::size_t waiting_ = 0;  ///< frames that are not at their end
  bool started_ = false;
};

/// A frame every period. What could not be sent for a long time is left out.
class PeriodicTalker final : public Talker {
 public:
  PeriodicTalker(Medium& medium, injection::Trigger& trigger, const can_frame& frame, canopen::Duration period);

 private:
  void begin(canopen::TimePoint now) noexcept override { next_ = now; }
  [[nodiscard]] canopen::TimePoint wanted() const noexcept override { return next_; }
  void go_on(canopen::TimePoint now) noexcept override;

  canopen::Duration period_;
  canopen::TimePoint next_ = canopen::kNever;
};

/// Always has frames that wait for the bus.
class EagerTalker final : public Talker {
 public:
  using Talker::Talker;

 private:
  void begin(canopen::TimePoint now) noexcept override { next_ = now; }
  [[nodiscard]] canopen::TimePoint wanted() const noexcept override;
  void go_on(canopen::TimePoint now) noexcept override;

  canopen::TimePoint next_ = canopen::kNever;  ///< not before
};

/// Sends as many frames as the bus needs to be busy for a share of its time, those of all others included.
class FillingTalker final : public Talker {
 public:
  FillingTalker(Medium& medium, injection::Trigger& trigger, const can_frame& frame, std::uint32_t percent);

  void on_frame(const Passage& passage, canopen::TimePoint end) noexcept override;

 private:
  void begin(canopen::TimePoint now) noexcept override { next_ = now; }
  [[nodiscard]] canopen::TimePoint wanted() const noexcept override;
  void go_on(canopen::TimePoint now) noexcept override;
  void use(canopen::Duration time) noexcept;

  std::uint32_t percent_;
  canopen::TimePoint next_ = canopen::kNever;  ///< when what was on the bus so far is no more than the share
};

}  // namespace hub::faults
