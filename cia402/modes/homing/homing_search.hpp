#pragma once

#include <cstdint>

#include "cia402/inputs/input_event.hpp"
#include "cia402/modes/homing/homing_methods.hpp"

namespace cia402 {

/// Which way a homing goes on at each event, until it comes past its home: regions and edges, no time and no
/// motion.
class HomingSearch {
 public:
  /// Begins where the motor is at @p position (increments), with the inputs at @p levels. The way of @p method,
  /// which must outlive the search, is not Rest.
  void begin(const HomingMethod& method, const InputLevels& levels, double position) noexcept;
  /// Something has happened. Whether it is of any meaning to the search.
  bool follow(const InputEvent& event) noexcept;

  bool has_found() const noexcept { return step_ == Step::Found; }
  /// A limit switch that the method does not use, or one more than it uses, stands in the way.
  bool has_failed() const noexcept { return step_ == Step::Failed; }
  /// Exact (increments of the motor), once it is found.
  double home() const noexcept { return home_; }
  /// Where to go.
  Direction direction() const noexcept { return direction_; }
  /// With 6099h:2: behind the first edge of the switch, in final direction.
  bool is_slow() const noexcept {
    return step_ == Step::Index || (has_edge_ && direction_ == method_->final_direction);
  }

 private:
  enum class Step : std::uint8_t { Edge, Index, Found, Failed };

  bool is_final(const InputEvent& event) const noexcept;
  void cross(double position) noexcept;
  void turn_at(Edge edge) noexcept;
  bool look_ahead() noexcept;

  const HomingMethod* method_ = &kHomingMethods.front();
  Step step_ = Step::Edge;
  Direction direction_ = Direction::Positive;
  InputLevels levels_{};
  double start_ = 0.0;      // increments
  double home_ = 0.0;       // increments
  bool has_edge_ = false;   // of the switch, whichever
  bool is_turned_ = false;  // by the limit switch that reverses
};

}  // namespace cia402
