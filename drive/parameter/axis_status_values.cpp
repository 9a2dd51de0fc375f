// The status and control words that parameters show of an axis.
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "drive/axis.hpp"
#include "drive/parameter/axis_values.hpp"

namespace drive::axis_value {
namespace {

bool no_off2(const AxisInputs& inputs) noexcept {
  return inputs.no_off2 && inputs.no_off2_second;
}
bool no_off3(const AxisInputs& inputs) noexcept {
  return inputs.no_off3 && inputs.no_off3_second;
}

struct Bit {
  unsigned number;
  bool on;
};

double word(std::span<const Bit> bits) noexcept {
  std::uint32_t value = 0;
  for (const Bit& bit : bits) value |= static_cast<std::uint32_t>(bit.on) << bit.number;
  return value;
}

bool is(const Axis& axis, State state) noexcept {
  return axis.actual().state == state;
}

/// Switch on disabled has several reasons; the highest number is shown.
double inhibited_display(const AxisInsight& seen) noexcept {
  struct Reason {
    bool holds;
    double code;
  };
  const std::array reasons{Reason{seen.switching_on_inhibited, 46.0}, Reason{!no_off3(seen.inputs), 43.0},
                           Reason{!no_off2(seen.inputs), 42.0}};
  for (const Reason& reason : reasons)
    if (reason.holds) return reason.code;
  return 41.0;  // ON is still set
}

/// r0002 by state; of Switch on disabled the lowest.
constexpr std::array<double, kStateCount> kDisplays{70.0, 41.0, 31.0, 21.0, 0.0, 16.0, 17.0, 18.0, 45.0};

}  // namespace

double operating_display(const Axis& axis, std::size_t) noexcept {
  if (is(axis, State::SwitchOnDisabled)) return inhibited_display(axis.insight());
  return kDisplays[static_cast<std::size_t>(axis.actual().state)];
}

double statusword(const Axis& axis, std::size_t) noexcept {
  return axis.actual().statusword;
}

double controlword(const Axis& axis, std::size_t) noexcept {
  return axis.insight().inputs.controlword;
}

double missing_enables(const Axis& axis, std::size_t) noexcept {
  const AxisInsight seen = axis.insight();
  const bool fault = is(axis, State::Fault) || is(axis, State::FaultReactionActive);
  const std::array bits{Bit{0, !seen.inputs.on},
                        Bit{1, !no_off2(seen.inputs)},
                        Bit{2, !no_off3(seen.inputs)},
                        Bit{3, !seen.inputs.enable_operation},
                        Bit{17, fault || seen.switching_on_inhibited},
                        Bit{19, !axis.actual().pulses_enabled},
                        Bit{30, !axis.actual().pulses_enabled}};
  return word(bits);
}

double control_status(const Axis& axis, std::size_t) noexcept {
  return word(std::array{Bit{0, !is(axis, State::NotReadyToSwitchOn)}, Bit{2, axis.actual().pulses_enabled}});
}

double sequence_control(const Axis& axis, std::size_t) noexcept {
  const AxisInputs inputs = axis.insight().inputs;
  return word(std::array{Bit{0, inputs.on}, Bit{1, no_off2(inputs)}, Bit{2, no_off3(inputs)},
                         Bit{3, inputs.enable_operation}, Bit{4, inputs.enable_ramp}, Bit{5, inputs.continue_ramp},
                         Bit{6, inputs.enable_setpoint}, Bit{8, inputs.jog_1}, Bit{9, inputs.jog_2},
                         Bit{10, inputs.control_by_plc}});
}

double sequence_status(const Axis& axis, std::size_t) noexcept {
  constexpr unsigned kOfTheStatusword = 0x0277;  // bits 0..2, 4..6 and 9 are the same
  const bool inhibited = is(axis, State::Fault);
  const bool pulses = axis.actual().pulses_enabled;
  const auto own = static_cast<std::uint32_t>(
      word(std::array{Bit{6, inhibited}, Bit{7, !inhibited}, Bit{8, pulses}, Bit{11, pulses}}));
  return (axis.actual().statusword & kOfTheStatusword) | own;
}

double speed_controller_control(const Axis& axis, std::size_t) noexcept {
  return word(std::array{Bit{4, axis.actual().pulses_enabled}});
}

double speed_controller_status(const Axis& axis, std::size_t) noexcept {
  const bool pulses = axis.actual().pulses_enabled;
  const AxisInsight seen = axis.insight();
  return word(std::array{Bit{2, pulses && seen.torque_control}, Bit{3, pulses && !seen.torque_control},
                         Bit{7, seen.torque_limit_reached}});
}

double speed_status(const Axis& axis, std::size_t) noexcept {
  const double speed = std::abs(axis.actual().speed);
  const double threshold = axis.read(2155).value_or(0.0) * kRpm;
  return word(std::array{Bit{1, speed > axis.parameters().standstill_threshold}, Bit{4, speed > threshold},
                         Bit{5, speed <= threshold}, Bit{6, speed >= std::abs(axis.insight().ramp_input)}});
}

double monitoring_1(const Axis& axis, std::size_t) noexcept {
  const AxisInsight seen = axis.insight();
  const bool standstill = std::abs(axis.actual().speed) < axis.parameters().standstill_threshold;
  return word(std::array{Bit{5, standstill}, Bit{6, seen.overspeed}, Bit{7, seen.target_reached}});
}

double monitoring_2(const Axis& axis, std::size_t) noexcept {
  return word(std::array{Bit{6, axis.insight().blocked}});
}

double monitoring_3(const Axis& axis, std::size_t) noexcept {
  return word(std::array{Bit{0, std::abs(axis.actual().speed) < axis.parameters().zero_speed_threshold}});
}

}  // namespace drive::axis_value
