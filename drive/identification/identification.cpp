#include "drive/identification/identification.hpp"

#include <numbers>

#include "drive/speed_control/operating_mode.hpp"
#include "motor/control/field/induction_circuit.hpp"

namespace drive {

using Part = IdentificationPart;
using selection::kNone;

namespace {

/// Of an induction machine, what shares of a characteristic refer to (V·s).
double rated_flux_of(const motor::MachineData& machine) noexcept {
  return motor::standing_flux(motor::induction_circuit(machine),
                              std::numbers::sqrt2 * machine.induction.magnetising_current);
}

}  // namespace

void Identification::select_standstill(std::int32_t value) noexcept {
  selection_.standstill = value;
  settle();
}

void Identification::select_rotating(std::int32_t value) noexcept {
  selection_.rotating = value;
  settle();
}

bool can_rotate(std::int32_t value, ObjectKind kind, std::int32_t control_mode) noexcept {
  if (!is_field_oriented(control_mode)) return false;
  if (kind != ObjectKind::Vector || value < selection::kMeasure) return true;
  const bool with_encoder = value % 2 != 0;
  return with_encoder == is_with_encoder(control_mode);
}

void Identification::select_both(std::int32_t value, std::int32_t rotating) noexcept {
  const bool rotates = value == selection::kBothMeasurements;
  selection_ = {.both = value,
                .standstill = value != kNone ? selection::kMeasure : kNone,
                .rotating = rotates ? rotating : kNone};
}

/// p1900 returns to 0 with the last of the other two.
void Identification::settle() noexcept {
  if (due() == Part::None) selection_.both = kNone;
}

IdentificationPart Identification::due() const noexcept {
  if (selection_.standstill != kNone) return Part::Standstill;
  return selection_.rotating != kNone ? Part::Rotating : Part::None;
}

bool Identification::is_taken_over(Part part) const noexcept {
  const std::int32_t standstill = selection_.standstill;
  if (part == Part::Standstill) return standstill == selection::kMeasure || standstill == selection::kMeasureCurve;
  return part == Part::Rotating && selection_.rotating > kNone;
}

void Identification::prepare(bool from_standstill) noexcept {
  if (due() == Part::None) return;
  phase_ = Phase::Waiting;
  from_standstill_ = from_standstill;
}

void Identification::start(const motor::StandstillTask& task) noexcept {
  standstill_.start(task);
  rated_flux_ = rated_flux_of(task.machine);
  phase_ = Phase::Running;
}

void Identification::start(const motor::RotatingTask& task) noexcept {
  rotating_.start(task);
  rated_flux_ = rated_flux_of(task.machine);
  phase_ = Phase::Running;
}

motor::MeasurementState Identification::state() const noexcept {
  return due() == Part::Standstill ? standstill_.state() : rotating_.state();
}

std::uint16_t Identification::fault_value() const noexcept {
  return due() == Part::Standstill ? static_cast<std::uint16_t>(standstill_.fault()) : rotating_.progress();
}

std::uint16_t Identification::progress() const noexcept {
  using namespace motor::measurement_step;
  switch (due()) {
    case Part::Standstill:
      return phase_ == Phase::Running ? standstill_.progress() : motor::measurement_step::kStandstill;
    case Part::Rotating:
      return phase_ == Phase::Running ? rotating_.progress() : kRotating;
    case Part::None:
      break;
  }
  return motor::measurement_step::kNone;
}

double Identification::share() const noexcept {
  if (phase_ != Phase::Running) return 0.0;
  return due() == Part::Standstill ? standstill_.share() : rotating_.share();
}

void Identification::finish() noexcept {
  phase_ = Phase::Idle;
  if (due() == Part::Standstill) {
    results_.standstill = standstill_.result();
    results_.standstill->curve.rated_flux = rated_flux_;
    select_standstill(kNone);
  } else {
    results_.rotating = rotating_.result();
    results_.rotating->rated_flux = rated_flux_;
    select_rotating(kNone);
  }
}

}  // namespace drive
