#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "unit/face.hpp"
#include "unit/runner.hpp"

namespace profidrive {

/// IF1: the process data that a controller exchanges with the drive objects of a unit beside its CAN bus, over
/// whatever door they come (PROFIdrive). It runs in cycles of p2048: what has come acts from the start of a cycle,
/// what is sent is sampled at the end of one.
class Interface final : public unit::Face {
 public:
  /// Of the unit that @p runner runs, which outlives this; to be attached to it. Nothing is allocated after that.
  explicit Interface(unit::Runner& runner);

  /// Whether drive object @p object exchanges process data here.
  bool has(std::uint8_t object) const noexcept;
  /// A controller sends the words of drive object @p object from word @p first (0..) on; they act with the next
  /// cycle. Words that the drive object does not have are dropped. Monitoring (p2040) begins, or begins anew. The
  /// time is what the runner was told.
  void receive(std::uint8_t object, std::span<const std::uint16_t> words, std::size_t first = 0) noexcept;
  /// A controller has looked at process data of @p object: monitoring that runs begins anew.
  void touch(std::uint8_t object) noexcept;
  /// A connection that had brought process data of @p object is gone: A01925, until some come again.
  void on_connection_lost(std::uint8_t object) noexcept;
  /// The words that @p object sends (r2053), as of the end of the last cycle.
  std::span<const std::uint16_t> sent(std::uint8_t object) const noexcept;
  /// The words that @p object has received (r2050), as they act.
  std::span<const std::uint16_t> received(std::uint8_t object) const noexcept;

  // unit::Face
  void bring() noexcept override;
  void show() noexcept override;
};

}  // namespace profidrive
