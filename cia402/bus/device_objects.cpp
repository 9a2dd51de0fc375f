#include "cia402/bus/device_objects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cia402/drive/drive_state.hpp"
#include "cia402/objects/object_index.hpp"
#include "cia402/objects/object_rows.hpp"
#include "version/version.hpp"

namespace cia402 {
namespace {

using motor::MachineData;

constexpr double kMilli = 1e-3;
constexpr double kPermille = 1e3;
constexpr std::uint8_t kSerialNumber = 4;

/// Motor types of 6402h (CiA 402-2).
enum : std::int64_t { kInductionMotor = 7, kPermanentMagnetMotor = 10 };

double per_mille(double value, double rated) noexcept {
  return rated > 0.0 ? kPermille * value / rated : 0.0;
}

/// An object of an axis whose value follows from its motor.
struct MotorRow {
  std::uint16_t index;
  std::uint8_t sub_index;
  double (*value)(const MachineData& machine) noexcept;
};
constexpr std::array kMotorRows{
    MotorRow{object::kVlVelocityMinMaxAmount, 2,
             [](const MachineData& m) noexcept { return m.maximum_speed / motor::kRpm; }},
    MotorRow{object::kMaxTorque, 0,
             [](const MachineData& m) noexcept { return per_mille(m.maximum_torque, m.rated_torque); }},
    MotorRow{object::kMaxCurrent, 0,
             [](const MachineData& m) noexcept { return per_mille(m.maximum_current, m.rated_current); }},
    MotorRow{object::kMotorRatedCurrent, 0,
             [](const MachineData& m) noexcept { return m.rated_current / kMilli; }},
    MotorRow{object::kMotorRatedTorque, 0, [](const MachineData& m) noexcept { return m.rated_torque / kMilli; }},
    MotorRow{object::kMaxProfileVelocity, 0,
             [](const MachineData& m) noexcept {
               return m.maximum_speed / (2.0 * std::numbers::pi) * double{kIncrements};
             }},
    MotorRow{object::kMaxMotorSpeed, 0,
             [](const MachineData& m) noexcept { return m.maximum_speed / motor::kRpm; }},
    MotorRow{object::kPositiveTorqueLimit, 0,
             [](const MachineData& m) noexcept { return per_mille(m.maximum_torque, m.rated_torque); }},
    MotorRow{object::kNegativeTorqueLimit, 0,
             [](const MachineData& m) noexcept { return per_mille(m.maximum_torque, m.rated_torque); }},
    MotorRow{object::kMotorType, 0,
             [](const MachineData& m) noexcept {
               const bool is_induction = m.type == motor::MachineType::Induction;
               return static_cast<double>(is_induction ? kInductionMotor : kPermanentMagnetMotor);
             }},
};

canopen::EntryDescription* find(std::vector<canopen::EntryDescription>& rows, std::uint16_t index,
                                std::uint8_t sub_index) {
  const auto found = std::ranges::find_if(
      rows, [&](const auto& row) { return row.index == index && row.sub_index == sub_index; });
  return found != rows.end() ? &*found : nullptr;
}

}  // namespace

DeviceObjects::DeviceObjects(const Configuration& configuration)
    : rows{rows_of(configuration)}, dictionary{rows, configuration.node_id} {}

std::vector<canopen::EntryDescription> DeviceObjects::rows_of(const Configuration& configuration) {
  std::vector<canopen::EntryDescription> rows = object_rows(configuration.axes.size());
  find(rows, object::kIdentity, kSerialNumber)->initial = configuration.serial;
  find(rows, object::kSoftwareVersion, 0)->text = version::number();
  for (std::size_t axis = 1; axis <= configuration.axes.size(); ++axis)
    for (const MotorRow& row : kMotorRows)
      find(rows, object::index_on_axis(row.index, axis), row.sub_index)->initial =
          std::llround(row.value(configuration.axes[axis - 1].drive.machine));
  return rows;
}

}  // namespace cia402
