#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "record/file_writer.hpp"

namespace record {

/// What is to be recorded.
struct Plan {
  Segments::Plan files;
  Moment before{};  ///< by faults: how much of what went before
  Moment after{};   ///< by faults: how much of what comes behind it
  /// What may wait for the disk: 50 ms of a bus that is full are a twentieth of it.
  std::size_t queue_bytes = std::size_t{1} << 20;
};

/// Keeps the frames, events and samples of a unit, in the order in which they are handed over: in files as they
/// come, or, if they are made by faults, in memory, which is written to a file with the next fault. Whoever hands
/// over never waits; what has no room is counted, and the file says where. All functions belong to one thread.
/// Nothing is allocated after construction, but by status().
class Recorder {
 public:
  enum class State : std::uint8_t {
    Recording,  ///< a file is being written
    Armed,      ///< waits for a fault
    Stopping,   ///< the rest is being written
    Stopped,
    Failed  ///< a file cannot be written: the error says it
  };
  struct Status {
    State state;
    WriterStatus files;
    std::uint64_t lost = 0;    ///< records that had no room
    std::uint64_t faults = 0;  ///< that have made a file
  };

  /// Begins at @p now. Throws std::system_error.
  Recorder(const Plan& plan, Moment now);
  /// Waits until all is written.
  ~Recorder() { stop(last_); }
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  void on_frame(const canopen::Frame& frame, bool sent, Moment at) noexcept;
  /// A fault that comes makes a file, if that is how files are made.
  void on_event(const Event& event, Moment at) noexcept;
  /// @p values, at most kMostSignals, in the order of the head.
  void on_samples(std::span<const double> values, Moment at) noexcept;
  /// The time after a fault may be over.
  void on_time(Moment now) noexcept {
    if (until_ && now >= *until_) end_fault(now);
  }
  /// When on_time() is wanted next, if it is.
  std::optional<Moment> until() const noexcept { return until_; }
  /// Nothing more is taken; the rest is written.
  void stop(Moment now) noexcept;
  bool is_stopped() const noexcept { return stopped_; }
  /// Whether the state is Failed.
  bool has_failed() const noexcept { return writer_.has_failed(); }
  Status status();

 private:
  void keep(const RecordBytes& record, Moment at) noexcept;
  void enqueue(std::span<const std::byte> record, Moment at) noexcept;
  bool command(Command command, Moment at, EndReason reason = EndReason::Stopped) noexcept;
  void begin_fault(Moment at) noexcept;
  void end_fault(Moment now) noexcept;

  bool by_faults_;
  Moment after_;
  Queue queue_;
  History history_;
  FileWriter writer_;
  Moment last_;
  std::optional<Moment> until_{};  ///< by faults: a file is being written until then
  bool stopped_ = false;
  std::uint64_t lost_ = 0;
  std::uint64_t lost_told_ = 0;  ///< of these the file says it
  std::uint64_t faults_ = 0;
};

/// "recording", "armed", "stopping", "stopped" or "failed".
std::string_view name_of(Recorder::State state) noexcept;

}  // namespace record
