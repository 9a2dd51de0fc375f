#include "drive/positioning/referencing/flying_referencing.hpp"

#include <cmath>

namespace drive {

void FlyingReferencing::run(ModeContext& context) noexcept {
  corrects_ = false;
  if (context.rises(&PositionerInputs::reference) && context.inputs.reference_flying) {
    active_ = true;
    outside_ = false;
  }
  if (!context.inputs.reference) interrupt();
  context.messages.show(PositioningMessage::CorrectionOutsideWindow, outside_);
  if (!active_) return;
  const bool measured = awaits_probe_ && context.inputs.measured_value_valid;
  awaits_probe_ = !measured;  // for one slice no request, then the next edge is awaited
  if (measured) judge(context);
}

void FlyingReferencing::judge(ModeContext& context) noexcept {
  const PositionerSettings& settings = context.settings;
  const double coordinate = context.inputs.reference_coordinate[0];
  const double measured = context.inputs.measured_position;
  const double difference =
      context.has_modulo() ? modulo_way(measured, coordinate, context.modulo_range, 0) : coordinate - measured;
  const double size = std::abs(difference);
  const bool referenced = context.reference.is_set;
  outside_ = referenced && settings.outer_window > 0.0 && size > settings.outer_window;
  context.messages.show(PositioningMessage::CorrectionOutsideWindow, outside_);
  if (outside_ || (referenced && size < settings.inner_window)) return;
  difference_ = difference;
  corrects_ = true;
  context.reference.is_set = true;
}

}  // namespace drive
