#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "device/objects/object_index.hpp"
#include "drive/base/object_kind.hpp"

/// Which object is which parameter: said here and nowhere else.
namespace device {

/// How an object shows a parameter of the axis.
enum class Form : std::uint8_t {
  Number,       ///< the nearest whole number
  Slope,        ///< a ramp time as the slope from p1082 (increments/s²)
  TorqueLimit,  ///< per mille of the rated torque, both ways; 0 for the limits of a new axis
  ProfileType,  ///< p1115: 0 is a linear ramp (0), 1 one of limited jerk (3); CiA 402 has other types beside them
};

/// A profile object that is a parameter of the axis, which is the home of its value.
struct ObjectParameter {
  std::uint16_t index;  ///< on the first axis
  std::uint8_t sub_index;
  std::uint16_t parameter;
  Form form;
};
inline constexpr std::array kObjectParameters{
    ObjectParameter{object::kAbortConnectionOption, 0, 8641, Form::Number},
    ObjectParameter{object::kVelocityLimits, 1, 1080, Form::Number},
    ObjectParameter{object::kVelocityLimits, 2, 1082, Form::Number},
    ObjectParameter{object::kVelocityAcceleration, 1, 1082, Form::Number},
    ObjectParameter{object::kVelocityAcceleration, 2, 1120, Form::Number},
    ObjectParameter{object::kHaltOption, 0, 8791, Form::Number},
    ObjectParameter{object::kMaxTorque, 0, 1520, Form::TorqueLimit},
    ObjectParameter{object::kProfileAcceleration, 0, 1120, Form::Slope},
    ObjectParameter{object::kProfileDeceleration, 0, 1121, Form::Slope},
    ObjectParameter{object::kQuickStopDeceleration, 0, 1135, Form::Slope},
    ObjectParameter{object::kMotionProfileType, 0, 1115, Form::ProfileType},
};

/// What the index of a mirrored parameter selects.
enum class Indexed : std::uint8_t { SubIndex, Object };

/// The parameters `first` to `last` of the drive objects `kinds`, whose home is the dictionary, and the entry that
/// index 0 of the first one is; of an axis: of axis 1, the others by the offset rule.
struct Mirror {
  std::uint16_t first = 0, last = 0;
  drive::ObjectKinds kinds = drive::kAxes;
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  Indexed indexed = Indexed::SubIndex;
};
inline constexpr std::array kMirrors{
    Mirror{8600, 8600, drive::kControlUnit, 0x1000, 0},
    Mirror{8601, 8601, drive::kControlUnit, 0x1001, 0},
    Mirror{8602, 8602, drive::kControlUnit, 0x1005, 0},
    Mirror{8603, 8603, drive::kControlUnit, 0x1014, 0},
    Mirror{8604, 8604, drive::kControlUnit, 0x100C, 0, Indexed::Object},
    Mirror{8606, 8606, drive::kControlUnit, 0x1017, 0},
    Mirror{8607, 8607, drive::kControlUnit, 0x1018, 1},
    Mirror{8609, 8609, drive::kControlUnit, 0x1029, 1},
    Mirror{8610, 8610, drive::kControlUnit, 0x1200, 1},
    Mirror{8611, 8611, drive::kControlUnit, 0x1003, 0},
    Mirror{8612, 8612, drive::kControlUnit, 0x1201, 1},
    Mirror{8612, 8612, drive::kAxes, 0x1202, 1},
    Mirror{8700, 8707, drive::kAxes, 0x1400, 1},
    Mirror{8710, 8717, drive::kAxes, 0x1600, 1},
    Mirror{8720, 8727, drive::kAxes, 0x1800, 1},
    Mirror{8730, 8737, drive::kAxes, 0x1A00, 1},
    Mirror{8798, 8798, drive::kAxes, object::kVelocityFactor, 1},
};

/// A parameter that goes with an object without being the value of one of its entries.
struct Companion {
  std::uint16_t parameter;
  std::uint16_t index;
};
inline constexpr std::array kCompanions{
    Companion{1134, object::kMotionProfileType},  // with a ramp of limited jerk its slope never jumps
    Companion{1300, object::kModesOfOperation}, Companion{8744, 0x1400},  // where the PDOs are from
};

/// Whether parameter @p number is one of the objects @p first to @p last of the first axis or of the unit, or goes
/// with one.
constexpr bool is_of_objects(std::uint16_t number, std::uint16_t first, std::uint16_t last) noexcept {
  const auto is_one = [=](std::uint16_t index) { return first <= index && index <= last; };
  return std::ranges::any_of(
             kObjectParameters,
             [=](const ObjectParameter& row) { return row.parameter == number && is_one(row.index); }) ||
         std::ranges::any_of(
             kMirrors,
             [=](const Mirror& row) { return row.first <= number && number <= row.last && is_one(row.index); }) ||
         std::ranges::any_of(kCompanions,
                             [=](const Companion& row) { return row.parameter == number && is_one(row.index); });
}

}  // namespace device
