#include "record/file_writer.hpp"

#include <cerrno>
#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "os/clock.hpp"
#include "os/no_signals.hpp"

namespace record {
namespace {

/// How long records wait before they are written, unless somebody wakes the writer.
constexpr std::chrono::milliseconds kPause{50};

constexpr bool is_command(RecordType type) noexcept {
  return static_cast<std::uint16_t>(type) >= static_cast<std::uint16_t>(Command::Begin);
}

}  // namespace

FileWriter::FileWriter(Segments::Plan plan, Queue& queue, History& history)
    : by_faults_{plan.by_faults}, segments_{std::move(plan)}, queue_{queue}, history_{history} {
  if (os::stands_while_acting()) return;
  const os::NoSignals none;
  thread_ = std::thread{[this] { work(); }};
}

FileWriter::~FileWriter() {
  if (!thread_.joinable()) {
    write_out(/*is_last=*/true);
    return;
  }
  {
    const std::scoped_lock lock{mutex_};
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void FileWriter::wake() noexcept {
  keep_up();
  {
    const std::scoped_lock lock{mutex_};
    woken_ = true;
  }
  changed_.notify_all();
}

WriterStatus FileWriter::status() const {
  const std::scoped_lock lock{mutex_};
  return status_;
}

void FileWriter::work() noexcept {
  std::unique_lock lock{mutex_};
  while (!status_.is_over) {
    changed_.wait_for(lock, kPause, [this] { return stopping_ || woken_; });
    woken_ = false;
    const bool is_last = stopping_;
    lock.unlock();
    write_out(is_last);
    lock.lock();
  }
}

void FileWriter::write_out(bool is_last) noexcept {
  const bool goes_on = empty_queue();
  if (segments_.is_open())
    if (const int error = segments_.flush()) fail(error);
  const std::scoped_lock lock{mutex_};
  status_.bytes = finished_ + (segments_.is_open() ? segments_.size() : 0);
  status_.is_over = status_.is_over || is_last || !goes_on;
}

/// False with Command::Quit.
bool FileWriter::empty_queue() noexcept {
  RecordBuffer buffer{};
  while (true) {
    const auto record = queue_.pop(buffer);
    if (record.empty()) return true;
    const RecordType type = type_of(record);
    if (!is_command(type)) {
      take(record);
      continue;
    }
    const auto command = static_cast<Command>(type);
    carry_out(command, record);
    if (command == Command::Quit) return false;
  }
}

void FileWriter::carry_out(Command command, std::span<const std::byte> record) noexcept {
  switch (command) {
    case Command::Begin:
      return begin();
    case Command::History:
      return write_history();
    case Command::Finish:
      return finish(static_cast<EndReason>(number_at(record, kRecordHeadBytes, 1)), moment_of(record));
    case Command::Quit:
      return finish(EndReason::Stopped, moment_of(record));
  }
}

void FileWriter::write_history() noexcept {
  RecordBuffer buffer{};
  history_.for_each(buffer, [this](std::span<const std::byte> past) { take(past); });
  history_.clear();
  has_history_.store(false, std::memory_order_release);
}

void FileWriter::begin() noexcept {
  is_full_ = false;
  if (has_failed_) return;
  const int error = segments_.open();
  if (error != 0) return fail(error);
  try {
    const std::scoped_lock lock{mutex_};
    ++status_.files;
    status_.file = segments_.where();
  } catch (const std::exception&) {
    fail(ENOMEM);
  }
}

void FileWriter::take(std::span<const std::byte> record) noexcept {
  if (segments_.is_open() && !is_full_ && !segments_.has_room(record)) {
    const Moment at = moment_of(record);
    if (by_faults_) {
      is_full_ = true;
      finish(EndReason::Full, at);
    } else {
      finish(EndReason::Full, at);
      begin();
    }
  }
  write(record);
}

void FileWriter::write(std::span<const std::byte> record) noexcept {
  const bool is_open = segments_.is_open();
  if (is_open)
    if (const int error = segments_.write(record)) fail(error);
  const std::scoped_lock lock{mutex_};
  ++(is_open && !has_failed_ ? status_.records : status_.unwritten);
}

void FileWriter::finish(EndReason reason, Moment at) noexcept {
  if (!segments_.is_open()) return;
  if (const int error = segments_.close(reason, at)) return fail(error);
  finished_ += segments_.size();
}

void FileWriter::fail(int error) noexcept {
  segments_.abandon();
  try {
    const std::scoped_lock lock{mutex_};
    status_.error = segments_.where() + ": " + std::generic_category().message(error);
  } catch (const std::exception&) {
    const std::scoped_lock lock{mutex_};
    status_.error = "no memory";
  }
  has_failed_.store(true, std::memory_order_release);
}

}  // namespace record
