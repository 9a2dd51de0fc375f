#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "daemon/configuration/configuration.hpp"
#include "daemon/watch/event_watch.hpp"
#include "daemon/watch/frame_tap.hpp"
#include "record/recorder.hpp"
#include "trace/signal/signal.hpp"

namespace axisd {

/// The recording of a unit, if there is one: its frames, its events and values of signals. While nothing is
/// recorded it hears nothing.
class UnitRecording final : private FrameListener, private EventListener {
 public:
  /// The unit that is recorded; all of it outlives the recording.
  struct Unit {
    const Configuration& configuration;
    device::Device& device;
    FrameTap& frames;
    EventWatch& events;
    std::filesystem::path folder;  ///< of its state; the files go below it
    canopen::TimePoint started;    ///< zero of the times in the files
  };
  /// Why a recording has not begun.
  struct Refusal {
    enum class Why : std::uint8_t { NoSuchSignal, Busy, NoThread };
    Why why;
    std::string message;  ///< one line
  };

  explicit UnitRecording(Unit unit) : unit_{std::move(unit)} {}
  ~UnitRecording() override { end(); }
  UnitRecording(const UnitRecording&) = delete;
  UnitRecording& operator=(const UnitRecording&) = delete;

  /// The signals that @p settings name, or what is wrong with one of them.
  tl::expected<std::vector<trace::Signal>, std::string> signals_of(const RecordSettings& settings) const;
  /// Begins to record at @p now.
  tl::expected<void, Refusal> start(const RecordSettings& settings, canopen::TimePoint now);
  /// Ends it; what is left is written beside the loop. Nothing happens if nothing is recorded.
  void stop(canopen::TimePoint now) noexcept;
  /// Ends it, and waits until all is written.
  void end() noexcept;

  /// What became of the last one, or of the present one.
  struct Status {
    RecordSettings settings;
    record::Recorder::Status recorder;
  };
  /// Nothing: there was none.
  std::optional<Status> status() const;
  /// Once for a recording that cannot be written, which is then over: why.
  std::optional<std::string> take_failure();

 private:
  void on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept override;
  void on_event(const UnitEvent& event) noexcept override;
  void on_handled(canopen::TimePoint now) noexcept override;
  canopen::TimePoint next_deadline() const noexcept override;

  record::Moment moment(canopen::TimePoint time) const noexcept { return time - unit_.started; }
  record::Plan plan(const RecordSettings& settings) const;
  std::string head(const RecordSettings& settings, std::chrono::nanoseconds wall_clock) const;
  void listen_no_more() noexcept;
  void sample(canopen::TimePoint now) noexcept;

  Unit unit_;
  RecordSettings settings_;
  std::vector<trace::Signal> signals_;
  canopen::Duration period_{};                  ///< of the samples; 0: every cycle
  canopen::TimePoint due_ = canopen::kNever;    ///< the next sample
  canopen::TimePoint last_cycle_{};             ///< that was sampled
  std::unique_ptr<record::Recorder> recorder_;  ///< also when it has ended
  bool is_listening_ = false;
};

}  // namespace axisd
