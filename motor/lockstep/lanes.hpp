#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include <experimental/simd>

#include "motor/math/curve.hpp"
#include "motor/math/number.hpp"
#include "motor/plant/shaft/load_torque.hpp"

/// Compiles all that is called into one function, so that lanes stay in registers. Not where every access is
/// checked, which takes a compiler minutes then.
#ifdef __SANITIZE_ADDRESS__
#define MOTOR_IN_ONE
#else
#define MOTOR_IN_ONE [[gnu::flatten]]
#endif

// Lanes: a number of each of several axes side by side, and what stands for curves and profiles there.
namespace motor {

/// How many.
template <class Number>
inline constexpr std::size_t kLanes = Number::size();

/// A number for each lane, in memory.
template <class Number>
using LaneArray = std::array<double, kLanes<Number>>;

template <class Number>
[[gnu::always_inline]] inline Number lanes(const LaneArray<Number>& values) noexcept {
  return Number{values.data(), std::experimental::element_aligned};
}
template <class Number>
[[gnu::always_inline]] inline LaneArray<Number> array(const Number& values) noexcept {
  LaneArray<Number> result;
  values.copy_to(result.data(), std::experimental::element_aligned);
  return result;
}

template <class Number>
class LaneCurves {
 public:
  /// @p lane reads @p curve, which outlives that.
  void set(std::size_t lane, const Curve& curve) noexcept {
    values_[lane] = curve.values().data();
    scale_[lane] = curve.scale();
  }
  Number at(const Number& argument) const noexcept {
    const Number place = Curve::place_of<Number>(argument, lanes<Number>(scale_));
    const Number whole = floor(place);
    const LaneArray<Number> index = array(whole);
    const auto value = [&](auto lane, int next) { return values_[lane][static_cast<int>(index[lane]) + next]; };
    const Number left{[&](auto lane) { return value(lane, 0); }};
    const Number right{[&](auto lane) { return value(lane, 1); }};
    return Curve::between<Number>(left, right, place - whole);
  }

 private:
  alignas(Number) std::array<const double*, kLanes<Number>> values_;
  LaneArray<Number> scale_;
};

template <class Number>
class LaneProfiles {
 public:
  /// @p lane walks through @p profile, which outlives that.
  void set(std::size_t lane, ProfileTorque& profile) noexcept { profiles_[lane] = &profile; }
  TorqueLineOf<Number> at(const Number& time) noexcept {
    const LaneArray<Number> times = array(time);
    LaneArray<Number> torque;
    LaneArray<Number> slope;
    for (std::size_t lane = 0; lane < kLanes<Number>; ++lane) {
      const TorqueLine line = profiles_[lane]->at(times[lane]);
      torque[lane] = line.torque;
      slope[lane] = line.slope;
    }
    return {lanes<Number>(torque), lanes<Number>(slope)};
  }

 private:
  std::array<ProfileTorque*, kLanes<Number>> profiles_;
};

/// Where an object of each axis begins.
template <class Number>
using LaneObjects = std::array<double*, kLanes<Number>>;

/// Numbers that an object in lanes holds one after the other, as the object of one axis does.
template <class Number, class InLanes>
inline constexpr std::size_t kNumbers = sizeof(InLanes) / sizeof(Number);

/// In @p lane, the first @p count numbers of @p in_lanes become those of @p axis,
template <class Number, class InLanes>
void enter_one(InLanes& in_lanes, std::size_t lane, const double* axis,
               std::size_t count = kNumbers<Number, InLanes>) noexcept {
  auto* const to = reinterpret_cast<std::byte*>(&in_lanes) + lane * sizeof(double);
  for (std::size_t i = 0; i < count; ++i) std::memcpy(to + i * sizeof(Number), axis + i, sizeof(double));
}
/// and those of @p axis what is in @p lane.
template <class Number, class InLanes>
void leave_one(const InLanes& in_lanes, std::size_t lane, double* axis,
               std::size_t count = kNumbers<Number, InLanes>) noexcept {
  const auto* const from = reinterpret_cast<const std::byte*>(&in_lanes) + lane * sizeof(double);
  for (std::size_t i = 0; i < count; ++i) std::memcpy(axis + i, from + i * sizeof(Number), sizeof(double));
}
/// The same in all lanes at once.
template <class Number, class InLanes>
void enter_all(InLanes& in_lanes, const LaneObjects<Number>& axes,
               std::size_t count = kNumbers<Number, InLanes>) noexcept {
  const LaneObjects<Number> from = axes;  // known to stay as it is, whatever is written
  auto* const to = reinterpret_cast<std::byte*>(&in_lanes);
  for (std::size_t i = 0; i < count; ++i) {
    const Number values{[&](auto lane) { return from[lane][i]; }};
    std::memcpy(to + i * sizeof(Number), &values, sizeof(Number));
  }
}
template <class Number, class InLanes>
void leave_all(const InLanes& in_lanes, const LaneObjects<Number>& axes,
               std::size_t count = kNumbers<Number, InLanes>) noexcept {
  const LaneObjects<Number> to = axes;
  const auto* const from = reinterpret_cast<const std::byte*>(&in_lanes);
  for (std::size_t i = 0; i < count; ++i) {
    Number values;
    std::memcpy(&values, from + i * sizeof(Number), sizeof(Number));
    [&]<std::size_t... kLane>(std::index_sequence<kLane...>) {
      ((to[kLane][i] = values[kLane]), ...);
    }
    (std::make_index_sequence<kLanes<Number>>{});
  }
}

}  // namespace motor
