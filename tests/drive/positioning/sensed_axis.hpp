#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "drive/positioning/actual_position/actual_position.hpp"

namespace drive {

/// The position of an axis whose encoder is turned by the test, in slices of 1 ms. Its encoder gives 1000
/// increments a revolution, for which the parameters of a new axis make 1000 LU.
struct SensedAxis {
  static constexpr std::int64_t kPerRevolution = 1000;

  static motor::EncoderData encoder(motor::EncoderType type = motor::EncoderType::Incremental) {
    return {.type = type, .pulses = 250, .fine_bits = 2, .revolutions = 16};
  }

  ActualPosition position;
  ActualPosition::Slice slice{};

  explicit SensedAxis(const motor::EncoderData& data = encoder()) : position{data} {
    position.settings.units_per_load = 1000;
  }

  /// A slice in which nothing moves and no input changes.
  void stay() { turn(0); }
  /// A slice in which the encoder turns by @p increments.
  void turn(std::int64_t increments) {
    slice.counts += increments;
    position.run(slice);
    slice.inputs.rising = slice.inputs.falling = InputEdges::none();
  }
  std::int64_t shown() const { return position.shown(); }

  /// In the next slice DI @p input goes to @p level at @p instant.
  void edge(unsigned input, bool level, double instant) {
    (level ? slice.inputs.rising : slice.inputs.falling)[input] = instant;
    const auto bit = static_cast<std::uint8_t>(1U << input);
    slice.inputs.levels =
        static_cast<std::uint8_t>(level ? slice.inputs.levels | bit : slice.inputs.levels & ~bit);
  }
};

}  // namespace drive
