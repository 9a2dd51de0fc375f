#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include <sys/socket.h>

#include "can/userbus/protocol.hpp"

namespace hub {

/// What goes to one member, in order: into its socket, and if that is full into a ring of bounded size. What finds
/// no room is dropped and counted. Nobody waits.
///
/// Frames are gathered, and go with one system call when they are handed over; in one message, if the member takes
/// such.
class Outbox {
 public:
  /// Messages that may wait beside what the socket holds; a frame counts as one, whatever it comes in.
  static constexpr std::size_t kMessages = 4096;

  /// Sends to @p descriptor, which must outlive this.
  explicit Outbox(int descriptor) noexcept : descriptor_{descriptor} {}

  /// From now on up to @p most frames, 1 to userbus::kMostFrames, go in one message.
  void set_most_frames(std::size_t most) noexcept;

  /// A frame more that is to be handed over, for the caller to fill in; only if not is_full().
  [[nodiscard]] userbus::FrameMessage& add() noexcept { return gathered_[count_++]; }
  /// True if nothing can be gathered until hand_over().
  [[nodiscard]] bool is_full() const noexcept { return count_ == most_at_once_; }
  /// True if nothing was gathered since hand_over().
  [[nodiscard]] bool has_none() const noexcept { return count_ == 0; }
  /// Sends what was gathered; frames for which there is no room count as lost. Here, so that handing over to many
  /// members is one loop around a system call: after each one the processor has to find again what it touches.
  void hand_over() noexcept {
    if (count_ == 0) return;
    const bool is_one_message = in_one_ || count_ == 1;
    if (is_one_message && empty() && write_message(gathered_.data(), count_ * sizeof gathered_[0]))
      taken_ += std::exchange(count_, 0);
    else
      hand_over_rest();
  }

  /// Takes @p message (at most userbus::kLongestMessage bytes), behind what was gathered; one for which there is
  /// no room counts as lost.
  void send(std::span<const std::byte> message) noexcept;
  /// Takes @p message likewise if there is room; false if there is none.
  [[nodiscard]] bool offer(std::span<const std::byte> message) noexcept;
  /// Puts what waits into the socket, as far as that has room.
  void flush() noexcept;

  /// True if nothing waits; what was gathered does not count.
  [[nodiscard]] bool empty() const noexcept { return messages_ == 0; }
  /// Messages that wait, what was gathered not counted.
  [[nodiscard]] std::size_t waiting() const noexcept { return messages_; }
  /// Messages and frames that were taken.
  [[nodiscard]] std::uint64_t taken() const noexcept { return taken_; }
  /// Messages and frames that were lost.
  [[nodiscard]] std::uint32_t dropped() const noexcept { return dropped_; }

 private:
  using Length = std::uint32_t;
  static constexpr int kFlags = MSG_DONTWAIT | MSG_NOSIGNAL;
  /// Messages of one system call, at most.
  static constexpr std::size_t kAtOnce = userbus::kMostFrames;
  /// Of the ring (bytes): room for kMessages frames.
  static constexpr std::size_t kRoom = kMessages * (sizeof(Length) + sizeof(userbus::FrameMessage));

  /// Messages one behind the other.
  struct Batch {
    std::span<const std::byte> bytes;
    std::span<const Length> lengths;
  };
  /// What became of the messages of a Batch, from the first on; the others found no room.
  struct Outcome {
    std::size_t sent = 0;
    std::size_t lost = 0;  ///< of those behind: nobody is there to read them
  };

  /// False with errno if the socket does not take it.
  [[nodiscard]] bool write_message(const void* message, std::size_t size) const noexcept {
    return ::send(descriptor_, message, size, kFlags) >= 0;
  }
  void hand_over_rest() noexcept;
  [[nodiscard]] Outcome write(const Batch& batch) const noexcept;
  [[nodiscard]] Outcome write_in_one(const Batch& batch) const noexcept;
  [[nodiscard]] Outcome write_each(const Batch& batch) const noexcept;
  [[nodiscard]] bool keep(std::span<const std::byte> message) noexcept;
  void put(std::span<const std::byte> bytes) noexcept;
  void get(std::span<std::byte> bytes, std::size_t offset) const noexcept;
  [[nodiscard]] Batch oldest(std::span<std::byte> bytes, std::span<Length> lengths) const noexcept;

  // What every frame touches lies together, up to the first one that is gathered: of many members little is in the
  // processor's cache.
  int descriptor_;
  bool in_one_ = false;                 ///< several frames go in one message
  std::size_t most_at_once_ = kAtOnce;  ///< frames of one system call
  std::size_t count_ = 0;               ///< of gathered_
  std::size_t messages_ = 0;            ///< in ring_
  std::uint64_t taken_ = 0;
  std::uint32_t dropped_ = 0;
  std::array<userbus::FrameMessage, userbus::kMostFrames> gathered_{};
  std::unique_ptr<std::byte[]> ring_;  ///< only members that fall behind have one
  std::size_t first_ = 0;              ///< where the oldest message begins
  std::size_t used_ = 0;
};

}  // namespace hub
