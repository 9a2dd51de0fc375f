#include "motor/control/field/field_control.hpp"

#include <numbers>

#include "motor/control/field/field_without_encoder.hpp"
#include "motor/control/field/induction_field.hpp"
#include "motor/control/field/synchronous_field.hpp"

namespace motor {
namespace {

constexpr double kFedSlope = 0.3;  // of the acceleration that the fed current can give

}  // namespace

template <class Field>
void FieldControl<Field>::configure(const MachineData& machine, const ControlSettings& settings,
                                    double delay) noexcept {
  const bool with_encoder = settings.mode == ControlMode::Encoder;
  with_encoder_ = with_encoder;
  loop_.configure(settings, with_encoder ? settings.speed : settings.sensorless_speed, delay);
  controller_.configure(settings.current, kControlPeriod);
  field_.configure(machine, settings);
  const double pole_pairs = field_.pole_pairs();
  changeover_ = pole_pairs * settings.changeover_speed;
  const double amplitude = std::numbers::sqrt2 * settings.start_current;
  fed_.configure(amplitude, kFedSlope * pole_pairs * field_.pull(amplitude) / settings.inertia);
}

template <class Field>
void FieldControl<Field>::start(double speed) noexcept {
  loop_.reset(speed);
  controller_.reset();
  field_.start();
  fed_.start({});
  if (!with_encoder_.holds()) field_.start_observer({}, {});
  feeding_ = true;
  surplus_ = 0.0;
  frequency_ = 0.0;
  ticks_ = kSlowTicks - 1.0;
}

template class FieldControl<SynchronousField<double>>;
template class FieldControl<InductionField<double>>;

}  // namespace motor
