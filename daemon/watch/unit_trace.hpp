#pragma once

#include <optional>
#include <utility>

#include <tl/expected.hpp>

#include "daemon/watch/cycle_tap.hpp"
#include "daemon/watch/event_watch.hpp"
#include "daemon/watch/frame_tap.hpp"
#include "device/device.hpp"
#include "trace/tracer.hpp"

namespace axisd {

/// The trace of a unit: while one is on, it is told the cycles, frames and events of the unit.
class UnitTrace final : private FrameListener, private EventListener {
 public:
  /// All arguments outlive this.
  UnitTrace(const device::Device& device, CycleTap& cycles, FrameTap& frames, EventWatch& events) noexcept
      : device_{device}, cycles_{cycles}, frames_{frames}, events_{events}, tracer_{device.unit()} {}
  ~UnitTrace() override = default;
  UnitTrace(const UnitTrace&) = delete;
  UnitTrace& operator=(const UnitTrace&) = delete;

  /// Begins a trace (see trace::Tracer::start()). Neither this nor stop() from within what the unit tells.
  tl::expected<void, trace::Problem> start(const trace::Settings& settings);
  void stop() noexcept;
  /// What start() would complain of.
  std::optional<trace::Problem> problem_of(const trace::Settings& settings) const;
  /// A trace that has ended by itself is told nothing more. After every turn.
  void look_around() noexcept {
    if (listens_ && !tracer_.is_on()) [[unlikely]]
      listen(false);
  }
  const trace::Tracer& tracer() const noexcept { return tracer_; }

 private:
  void listen(bool wanted) noexcept;
  void on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept override;
  void on_event(const UnitEvent& event) noexcept override;

  const device::Device& device_;
  CycleTap& cycles_;
  FrameTap& frames_;
  EventWatch& events_;
  trace::Tracer tracer_;
  bool listens_ = false;
};

}  // namespace axisd
