#include "record/recorder.hpp"

#include <algorithm>
#include <array>
#include <chrono>

namespace record {
namespace {

/// Kept free for commands and for what says that records were lost.
constexpr std::size_t kSpareBytes = 256;
/// What went before a fault: so much for each second, within these limits.
constexpr double kBytesPerSecond = 1 << 20;
constexpr double kLeastHistory = 1 << 18, kMostHistory = 1 << 24;

std::size_t history_bytes(const Plan& plan) {
  if (!plan.files.by_faults) return 1;
  const double wanted = std::chrono::duration<double>{plan.before}.count() * kBytesPerSecond;
  return static_cast<std::size_t>(std::clamp(wanted, kLeastHistory, kMostHistory));
}

constexpr std::array<std::string_view, 5> kStates{"recording", "armed", "stopping", "stopped", "failed"};

}  // namespace

std::string_view name_of(Recorder::State state) noexcept {
  return kStates[static_cast<std::size_t>(state)];
}

Recorder::Recorder(const Plan& plan, Moment now)
    : by_faults_{plan.files.by_faults},
      after_{plan.after},
      queue_{plan.queue_bytes},
      history_{history_bytes(plan), plan.before},
      writer_{plan.files, queue_, history_},
      last_{now} {
  if (!by_faults_) static_cast<void>(command(Command::Begin, now));
  writer_.keep_up();
}

void Recorder::on_frame(const canopen::Frame& frame, bool sent, Moment at) noexcept {
  keep(frame_record(frame, sent, at), at);
}

void Recorder::on_event(const Event& event, Moment at) noexcept {
  keep(event_record(event, at), at);
  if (by_faults_ && event.kind == EventKind::Fault && event.active) begin_fault(at);
}

void Recorder::on_samples(std::span<const double> values, Moment at) noexcept {
  keep(samples_record(values, at), at);
}

/// While the writer has the history, what comes before the next fault has no place.
void Recorder::keep(const RecordBytes& record, Moment at) noexcept {
  if (stopped_) return;
  last_ = std::max(last_, at);
  on_time(last_);
  if (!by_faults_ || until_) return enqueue(record.bytes(), last_);
  if (writer_.has_history()) {
    ++lost_;
    return;
  }
  history_.push(record.bytes(), last_);
}

void Recorder::enqueue(std::span<const std::byte> record, Moment at) noexcept {
  if (lost_ != lost_told_ && queue_.push(lost_record(lost_ - lost_told_, at).bytes(), kSpareBytes))
    lost_told_ = lost_;
  if (lost_ == lost_told_ && queue_.push(record, kSpareBytes)) return;
  writer_.keep_up();
  if (lost_ != lost_told_ || !queue_.push(record, kSpareBytes)) ++lost_;
}

bool Recorder::command(Command command, Moment at, EndReason reason) noexcept {
  RecordBytes record{static_cast<RecordType>(command), at};
  record.add_number(static_cast<std::uint64_t>(reason), 1);
  return queue_.push(record.bytes());
}

/// A further fault prolongs the file of the first. One whose history cannot be written yet makes none.
void Recorder::begin_fault(Moment at) noexcept {
  if (stopped_) return;
  const bool goes_on = until_.has_value();
  if (!goes_on && writer_.has_history()) return;
  until_ = at + after_;
  if (goes_on) return;
  ++faults_;
  writer_.hand_over_history();
  command(Command::Begin, at);
  command(Command::History, at);
  writer_.keep_up();
}

void Recorder::end_fault(Moment now) noexcept {
  if (!command(Command::Finish, now, EndReason::Over)) return;
  until_.reset();
  writer_.wake();
}

void Recorder::stop(Moment now) noexcept {
  if (stopped_) return;
  stopped_ = true;
  if (lost_ != lost_told_ && (!by_faults_ || until_))
    static_cast<void>(queue_.push(lost_record(lost_ - lost_told_, now).bytes()));
  command(Command::Quit, now);
  writer_.wake();
}

Recorder::Status Recorder::status() {
  writer_.keep_up();
  Status status{.state = State::Recording, .files = writer_.status(), .lost = lost_, .faults = faults_};
  if (!status.files.error.empty()) {
    status.state = State::Failed;
  } else if (stopped_) {
    status.state = status.files.is_over ? State::Stopped : State::Stopping;
  } else if (by_faults_ && !until_) {
    status.state = State::Armed;
  }
  return status;
}

}  // namespace record
