#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "daemon/instance/memory/state_files.hpp"
#include "os/descriptor.hpp"

namespace axisd {

/// Writes state files on a thread of its own: the disk is waited for there, and nowhere else. All functions belong
/// to one thread, that of the loop, and none but finish() waits. Nothing is allocated after construction.
class StateWriter {
 public:
  /// What can be written at the same time; each has its own place.
  enum class Place : std::uint8_t { Parameters, Retained };
  static constexpr std::size_t kPlaces = 2;
  /// The end of a write.
  struct Ended {
    Place place;
    tl::expected<void, WriteFailure> outcome;
  };

  /// Contents of up to @p longest bytes. Throws std::system_error.
  explicit StateWriter(std::size_t longest);
  /// Waits for what has begun.
  ~StateWriter();
  StateWriter(const StateWriter&) = delete;
  StateWriter& operator=(const StateWriter&) = delete;

  /// Begins to write @p content, of which it keeps a copy, to @p file, which outlives this and @p makes_room
  /// before. Nothing has begun at @p place, or its end has been taken.
  void begin(Place place, const StateFile& file, std::span<const std::byte> content, Durability durability,
             bool makes_room = false) noexcept;
  /// Readable when there is something to take, and once at the beginning: whoever waits for it can provide for
  /// that then, and allocates nothing later.
  int descriptor() const noexcept { return ended_.get(); }
  /// A write that has ended since the last call.
  std::optional<Ended> take_ended() noexcept;
  /// Waits for the end of all that has begun; it is to be taken as ever.
  void finish() noexcept;

 private:
  enum class State : std::uint8_t { Free, Waiting, Ended };
  struct Job {
    State state = State::Free;
    const StateFile* file = nullptr;
    std::vector<std::byte> content{};
    Durability durability = Durability::OnDisk;
    bool makes_room = false;
    tl::expected<void, WriteFailure> outcome{};
  };
  void work() noexcept;
  static tl::expected<void, WriteFailure> write(const Job& job) noexcept;
  void end(Job& job, const tl::expected<void, WriteFailure>& outcome) noexcept;
  Job* next_job() noexcept;

  std::array<Job, kPlaces> jobs_{};
  std::mutex mutex_;
  std::condition_variable changed_;
  bool stopping_ = false;
  os::Descriptor ended_;  ///< eventfd
  std::thread thread_;
};

}  // namespace axisd
