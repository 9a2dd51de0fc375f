#pragma once

#include <memory>

#include "tests/fuzz/events.hpp"

namespace fuzz {

/// Stations under different policies. The first byte of an input chooses one, the others are its events.
class Worlds {
 public:
  Worlds();
  /// Plays @p input and returns its transcript: the same input has the same transcript whatever was played before.
  std::uint64_t play(std::span<const std::uint8_t> input);
  /// Writes all frames to standard output from now on.
  void trace() noexcept;

 private:
  struct World {
    explicit World(const canopen::Policy& policy) : station{policy}, events{station} {}
    Station station;
    Events events;
  };
  std::vector<std::unique_ptr<World>> worlds_;
};

}  // namespace fuzz
