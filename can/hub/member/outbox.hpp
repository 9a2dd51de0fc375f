#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "can/userbus/protocol.hpp"

namespace hub {

/// What goes to one member, in order: into its socket, and if that is full into a ring of bounded size. What finds
/// no room is dropped and counted. Nobody waits.
class Outbox {
 public:
  /// Messages that may wait beside what the socket holds.
  static constexpr std::size_t kMessages = 4096;

  /// Sends to @p descriptor, which must outlive this.
  explicit Outbox(int descriptor) noexcept : descriptor_{descriptor} {}

  /// Takes @p message (at most userbus::kLongestMessage bytes); one for which there is no room counts as lost.
  void send(std::span<const std::byte> message) noexcept;
  /// Takes @p message likewise if there is room; false if there is none.
  [[nodiscard]] bool offer(std::span<const std::byte> message) noexcept;
  /// Puts what waits into the socket, as far as that has room.
  void flush() noexcept;

  /// True if nothing waits.
  [[nodiscard]] bool empty() const noexcept { return messages_ == 0; }
  /// Messages that were taken.
  [[nodiscard]] std::uint64_t taken() const noexcept { return taken_; }
  /// Messages that were lost.
  [[nodiscard]] std::uint32_t dropped() const noexcept { return dropped_; }

 private:
  /// What became of a message that was given to the socket.
  enum class Outcome : std::uint8_t { Sent, Full, Lost };
  using Length = std::uint32_t;
  /// Of the ring (bytes): room for kMessages frames.
  static constexpr std::size_t kRoom = kMessages * (sizeof(Length) + sizeof(userbus::FrameMessage));

  [[nodiscard]] Outcome write(std::span<const std::byte> message) const noexcept;
  [[nodiscard]] bool keep(std::span<const std::byte> message) noexcept;
  void put(std::span<const std::byte> bytes) noexcept;
  void get(std::span<std::byte> bytes, std::size_t offset) const noexcept;

  int descriptor_;
  std::unique_ptr<std::byte[]> ring_;  // only members that fall behind have one
  std::size_t first_ = 0;              // where the oldest message begins
  std::size_t used_ = 0;
  std::size_t messages_ = 0;
  std::uint64_t taken_ = 0;
  std::uint32_t dropped_ = 0;
};

}  // namespace hub
