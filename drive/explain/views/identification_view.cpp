#include "drive/explain/views/identification_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "drive/base/units.hpp"
#include "drive/catalogue/table.hpp"
#include "drive/object/drive_object.hpp"
#include "motor/control/field/induction_circuit.hpp"

namespace drive {
namespace {

using Part = IdentificationPart;
using motor::MachineType;

constexpr double kPercent = 100.0;

constexpr std::array<std::string_view, 5> kPhaseNames{"idle", "waiting", "measuring", "done", "failed"};

constexpr std::array<std::uint16_t, 2> kFailures{7990, 7985};

// What r0047 says of a measurement that runs.
struct StepText {
  std::uint16_t progress;
  Part part;
  std::string_view text;
};
namespace step = motor::measurement_step;
constexpr std::array kSteps{
    StepText{step::kStandstill, Part::Standstill, "comes to rest, aligns the rotor"},
    StepText{step::kEncoderTest, Part::Standstill, "finds the pole position"},
    StepText{step::kStatorResistance, Part::Standstill, "measures the stator resistance"},
    StepText{step::kDeadTime, Part::Standstill, "measures what dead time and valves take"},
    StepText{step::kSaliency, Part::Standstill, "measures the inductances of both axes"},
    StepText{step::kLeakage, Part::Standstill, "measures the leakage inductance"},
    StepText{step::kRotorTimeConstant, Part::Standstill, "measures rotor time constant and main inductance"},
    StepText{step::kSaturation, Part::Standstill, "measures the saturation characteristic"},
    StepText{step::kCircuit, Part::Standstill, "computes the circuit"},
    StepText{step::kRotating, Part::Rotating, "magnetises, or comes to rest"},
    StepText{step::kEncoderTest, Part::Rotating, "compares encoder and field"},
    StepText{step::kSaturation, Part::Rotating, "measures flux or saturation"},
    StepText{step::kInertia, Part::Rotating, "measures the moment of inertia"},
};

// What there can be found.
double factory(const Axis& axis, std::uint16_t number) {
  const PlacedRow* const placed = find_parameter(axis.kind(), number);
  return placed != nullptr ? factory_value(*placed->row, axis.context(), 0) : 0.0;
}
template <std::uint16_t Number>
double of_the_factory(const Axis& axis) {
  return factory(axis, Number);
}
motor::InductionCircuit circuit_of(const Axis& axis) {
  return motor::induction_circuit(axis.context().axis.machine);
}
constexpr double kMilli = 1e-3;

struct Quantity {
  std::uint16_t number;  ///< that shows it
  Part part;
  bool synchronous;
  bool induction;
  double (*data_sheet)(const Axis& axis);  ///< nullptr: a data sheet says nothing of it
};
constexpr std::array kQuantities{
    Quantity{1912, Part::Standstill, true, true, &of_the_factory<350>},
    Quantity{1925, Part::Standstill, true, true, nullptr},
    Quantity{1932, Part::Standstill, true, false, &of_the_factory<357>},
    Quantity{1934, Part::Standstill, true, false, &of_the_factory<356>},
    Quantity{1984, Part::Standstill, true, false, nullptr},
    Quantity{1914, Part::Standstill, false, true,
             [](const Axis& axis) { return circuit_of(axis).leakage / kMilli; }},
    Quantity{1927, Part::Standstill, false, true,
             [](const Axis& axis) { return circuit_of(axis).rotor_resistance; }},
    Quantity{1936, Part::Standstill, false, true,
             [](const Axis& axis) { return circuit_of(axis).magnetising_inductance / kMilli; }},
    Quantity{1913, Part::Standstill, false, true,
             [](const Axis& axis) {
               const motor::InductionCircuit circuit = circuit_of(axis);
               return circuit.magnetising_inductance / circuit.rotor_resistance / kMilli;
             }},
    Quantity{1937, Part::Rotating, true, false, &of_the_factory<316>},
    Quantity{1969, Part::Rotating, true, true,
             [](const Axis& axis) { return factory(axis, 341) * factory(axis, 342); }},
};

bool was_found(const Axis& axis, const Quantity& quantity) noexcept {
  const Identification::Results& results = axis.identification().results();
  const bool synchronous = axis.context().axis.machine.type == MachineType::Synchronous;
  const bool has =
      quantity.part == Part::Standstill ? results.standstill.has_value() : results.rotating.has_value();
  return has && (synchronous ? quantity.synchronous : quantity.induction);
}

std::vector<IdentifiedValue> results_of(const Axis& axis) {
  std::vector<IdentifiedValue> found;
  for (const Quantity& quantity : kQuantities) {
    const PlacedRow* const placed = find_parameter(axis.kind(), quantity.number);
    if (placed == nullptr || !was_found(axis, quantity)) continue;
    IdentifiedValue value{.row = placed->row, .value = axis.read(quantity.number).value_or(0.0)};
    if (quantity.data_sheet != nullptr) value.data_sheet = quantity.data_sheet(axis);
    found.push_back(value);
  }
  return found;
}

bool has_failed(const Axis& axis) noexcept {
  return std::ranges::any_of(axis.messages().faults(), [](const FaultEntry& fault) {
    return std::ranges::count(kFailures, fault.row->number) != 0;
  });
}

IdentificationPhase phase_of(const Axis& axis) noexcept {
  const Identification& identification = axis.identification();
  if (identification.running() != Part::None) return IdentificationPhase::Measuring;
  if (has_failed(axis)) return IdentificationPhase::Failed;
  if (identification.due() != Part::None) return IdentificationPhase::Waiting;
  const Identification::Results& results = identification.results();
  return results.standstill || results.rotating ? IdentificationPhase::Done : IdentificationPhase::Idle;
}

std::string selected_of(const IdentificationSelection& selection) {
  std::string text;
  if (selection.standstill != selection::kNone) text = "standstill (p1910)";
  if (selection.rotating != selection::kNone) text += text.empty() ? "rotating (p1960)" : ", rotating (p1960)";
  return text.empty() ? "none" : text;
}

std::string step_text(const Identification& identification) {
  const std::uint16_t progress = identification.progress();
  const auto* const row = std::ranges::find_if(kSteps, [&](const StepText& known) {
    return known.progress == progress && known.part == identification.running();
  });
  return fmt::format("{} (r0047 = {})", row != kSteps.end() ? row->text : "measures", progress);
}

std::string waiting_text(const Identification& identification) {
  if (identification.waits()) return "waits until the holding brake is open and the shaft stands (r0002 = 14)";
  const bool stands = identification.due() == Part::Standstill;
  return fmt::format("the next ON measures the motor {}", stands ? "at standstill" : "turning, up to p1082");
}

std::string text_of(const Axis& axis, IdentificationPhase phase) {
  switch (phase) {
    case IdentificationPhase::Idle:
      return "nothing is selected: write p1900, p1910 or p1960";
    case IdentificationPhase::Waiting:
      return waiting_text(axis.identification());
    case IdentificationPhase::Measuring:
      return step_text(axis.identification());
    case IdentificationPhase::Done:
      return "done: what was found is in r1912 to r1984";
    case IdentificationPhase::Failed:
      break;
  }
  return "failed: the fault value of F07990 or F07985 says where";
}

}  // namespace

std::string_view name_of(IdentificationPhase phase) noexcept {
  return kPhaseNames[static_cast<std::size_t>(phase)];
}

std::optional<double> IdentifiedValue::deviation() const noexcept {
  if (!data_sheet || !(std::abs(*data_sheet) > 0.0)) return std::nullopt;
  return (value - *data_sheet) / *data_sheet * kPercent;
}

IdentificationView identification_of(const Axis& axis) {
  const IdentificationPhase phase = phase_of(axis);
  return {.selected = selected_of(axis.identification().selection()),
          .phase = phase,
          .progress = axis.identification().share() * kPercent,
          .text = text_of(axis, phase),
          .results = results_of(axis)};
}

}  // namespace drive
