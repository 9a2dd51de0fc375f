#pragma once

#include "motor/identification/rotating/field_reader.hpp"
#include "motor/identification/rotating/rotating_task.hpp"
#include "motor/identification/rotating/speed_plan.hpp"

namespace motor {

/// What the steps of a rotating measurement hand on to each other.
struct RotatingFindings {
  RotatingResult result{};
  double slope = 0.0;       ///< that suits the load (rad/s²)
  double dc_voltage = 0.0;  ///< at the start of the step (V)
};

/// One step of a rotating measurement: the speeds it wants, and what it makes of what is seen there.
class RotatingStep {
 public:
  virtual ~RotatingStep() = default;
  /// Begins anew. The speeds; none where @p task leaves no room for it.
  virtual SpeedPlan start(const RotatingTask& task, const RotatingFindings& found) noexcept = 0;
  /// Takes in what was seen at @p place.
  virtual void take(const FieldBlock& block, const SpeedPlace& place) noexcept = 0;
  /// Adds to @p found at the end of the plan; false if what was seen cannot be.
  virtual bool finish(RotatingFindings& found) noexcept = 0;

 protected:
  RotatingStep() = default;
  RotatingStep(const RotatingStep&) = default;
  RotatingStep& operator=(const RotatingStep&) = default;
};

}  // namespace motor
