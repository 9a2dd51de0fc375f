#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "record/history.hpp"
#include "record/queue.hpp"
#include "record/segments.hpp"

namespace record {

/// What the thread that hands records over wants of the writer; in the queue among the records.
enum class Command : std::uint16_t {
  Begin = 0xFFF0,    ///< begin a file
  History = 0xFFF1,  ///< write the history and give it back
  Finish = 0xFFF2,   ///< end the file; the payload is the reason
  Quit = 0xFFF3,     ///< end the file and the thread
};

/// What has been written.
struct WriterStatus {
  std::uint64_t bytes = 0;  ///< of the files, also of those that have made room
  std::uint64_t records = 0;
  std::uint64_t unwritten = 0;  ///< records that came when no file could be written
  unsigned files = 0;           ///< begun
  bool is_over = false;         ///< the thread has nothing left to do
  std::string file;             ///< that was begun last
  std::string error;            ///< why nothing more is written; empty: no error
};

/// Takes records out of a queue and writes them to files, on a thread of its own: the disk is waited for there,
/// and nowhere else. With the first error it writes no more, and goes on emptying the queue. Where the time of the
/// process stands while it acts, there is no such thread, and what is waited for takes none of it.
class FileWriter {
 public:
  /// Both arguments outlive this; @p history is the writer's from Command::History on until it is given back.
  /// Throws std::system_error.
  FileWriter(Segments::Plan plan, Queue& queue, History& history);
  /// Ends the thread, once the queue is empty.
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  /// Does not wait for the next look at the queue, which is at most 50 ms away.
  void wake() noexcept;
  /// Without a thread: empties the queue now.
  void keep_up() noexcept {
    if (!thread_.joinable()) write_out(/*is_last=*/false);
  }
  /// Whether Command::History is being carried out, as far as has_history() was not yet asked.
  bool has_history() const noexcept { return has_history_.load(std::memory_order_acquire); }
  /// By the other thread, before it hands the history over.
  void hand_over_history() noexcept { has_history_.store(true, std::memory_order_release); }
  WriterStatus status() const;
  /// Whether status() has an error.
  bool has_failed() const noexcept { return has_failed_.load(std::memory_order_acquire); }

 private:
  void work() noexcept;
  void write_out(bool is_last) noexcept;
  bool empty_queue() noexcept;
  void carry_out(Command command, std::span<const std::byte> record) noexcept;
  void write_history() noexcept;
  void take(std::span<const std::byte> record) noexcept;
  void begin() noexcept;
  void write(std::span<const std::byte> record) noexcept;
  void finish(EndReason reason, Moment at) noexcept;
  void fail(int error) noexcept;

  const bool by_faults_;
  Segments segments_;
  Queue& queue_;
  History& history_;
  std::atomic<bool> has_history_{false};
  bool is_full_ = false;  ///< the open file was to take no more: what comes is left out
  std::atomic<bool> has_failed_{false};
  std::uint64_t finished_ = 0;  ///< bytes of files that were closed
  mutable std::mutex mutex_;    ///< of what follows
  std::condition_variable changed_;
  bool woken_ = false;
  bool stopping_ = false;
  WriterStatus status_;
  std::thread thread_;
};

}  // namespace record
