#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "cia402/inputs/input_event.hpp"

namespace cia402 {

enum class Direction : std::int8_t { Negative = -1, Positive = 1 };

constexpr double sign_of(Direction direction) noexcept {
  return static_cast<double>(direction);
}
constexpr Direction opposite(Direction direction) noexcept {
  return direction == Direction::Positive ? Direction::Negative : Direction::Positive;
}

/// A homing method (6098h; CiA 402-2).
struct HomingMethod {
  /// How the axis comes to its home.
  enum class Way : std::uint8_t {
    Switch,  ///< to one side of an edge, then across it
    Ahead,   ///< on in one direction until the edge comes
    Rest,    ///< not at all: it is where it stands
  };
  /// What is home.
  enum class Place : std::uint8_t {
    Edge,   ///< the final edge
    Index,  ///< the first index pulse from there on
  };

  std::int8_t number = 0;
  Way way = Way::Rest;
  Direction initial = Direction::Positive;  ///< of a motion that begins while the signal is 0
  std::optional<Signal> reverses{};         ///< limit switch that turns it round, once
  Signal signal = Signal::Home;             ///< whose edge is searched for
  Edge edge = Edge::Rising;                 ///< that edge, met in final direction
  Direction final_direction = Direction::Positive;
  Place home = Place::Edge;
};

namespace homing_methods {

inline constexpr std::size_t kOfSwitches = 14;
inline constexpr std::int8_t kWithoutIndex = 16;  // so much higher is the number of the method that needs no index

/// Methods 1 to 14.
inline constexpr std::array<HomingMethod, kOfSwitches> kToIndex = [] {
  using enum Edge;
  using enum Signal;
  constexpr auto kWay = HomingMethod::Way::Switch;
  constexpr auto kIndex = HomingMethod::Place::Index;
  constexpr auto kMinus = Direction::Negative;
  constexpr auto kPlus = Direction::Positive;
  // number, way, initial motion, reverses, signal, edge, final motion, home
  return std::array<HomingMethod, kOfSwitches>{{
      {1, kWay, kMinus, {}, NegativeLimit, Falling, kPlus, kIndex},
      {2, kWay, kPlus, {}, PositiveLimit, Falling, kMinus, kIndex},
      {3, kWay, kPlus, {}, Home, Falling, kMinus, kIndex},
      {4, kWay, kPlus, {}, Home, Rising, kPlus, kIndex},
      {5, kWay, kMinus, {}, Home, Falling, kPlus, kIndex},
      {6, kWay, kMinus, {}, Home, Rising, kMinus, kIndex},
      {7, kWay, kPlus, PositiveLimit, Home, Falling, kMinus, kIndex},
      {8, kWay, kPlus, PositiveLimit, Home, Rising, kPlus, kIndex},
      {9, kWay, kPlus, PositiveLimit, Home, Rising, kMinus, kIndex},
      {10, kWay, kPlus, PositiveLimit, Home, Falling, kPlus, kIndex},
      {11, kWay, kMinus, NegativeLimit, Home, Falling, kPlus, kIndex},
      {12, kWay, kMinus, NegativeLimit, Home, Rising, kMinus, kIndex},
      {13, kWay, kMinus, NegativeLimit, Home, Rising, kPlus, kIndex},
      {14, kWay, kMinus, NegativeLimit, Home, Falling, kMinus, kIndex},
  }};
}();

/// Methods 33 to 37.
inline constexpr std::array<HomingMethod, 5> kOthers = [] {
  using enum Edge;
  using enum Signal;
  using enum HomingMethod::Way;
  constexpr auto kMinus = Direction::Negative;
  constexpr auto kPlus = Direction::Positive;
  return std::array<HomingMethod, 5>{{
      {.number = 33, .way = Ahead, .signal = Index, .edge = Pulse, .final_direction = kMinus},
      {.number = 34, .way = Ahead, .signal = Index, .edge = Pulse, .final_direction = kPlus},
      {.number = 35, .way = Rest},
      {.number = 36, .way = Ahead, .signal = Probe1, .edge = Rising, .final_direction = kPlus},
      {.number = 37, .way = Rest},
  }};
}();

}  // namespace homing_methods

/// Every method that there is, in the order of 60E3h.
inline constexpr auto kHomingMethods = [] {
  using namespace homing_methods;
  std::array<HomingMethod, 2 * kOfSwitches + kOthers.size()> all{};
  for (std::size_t i = 0; i < kOfSwitches; ++i) {
    all[i] = all[i + kOfSwitches] = kToIndex[i];
    all[i + kOfSwitches].number = static_cast<std::int8_t>(kToIndex[i].number + kWithoutIndex);
    all[i + kOfSwitches].home = HomingMethod::Place::Edge;
  }
  for (std::size_t i = 0; i < kOthers.size(); ++i) all[i + 2 * kOfSwitches] = kOthers[i];
  return all;
}();

/// The method of @p number (6098h); none for 0 and for what is reserved or not supported.
constexpr const HomingMethod* find_homing_method(std::int32_t number) noexcept {
  for (const HomingMethod& method : kHomingMethods)
    if (method.number == number) return &method;
  return nullptr;
}

}  // namespace cia402
