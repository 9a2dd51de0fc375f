#include "modbus/register_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "modbus/register_bank.hpp"

namespace modbus {
namespace {

using enum Content;
using enum Access;

constexpr Scale kTimes10{.multiplier = 10}, kTimes100{.multiplier = 100}, kTimes1000{.multiplier = 1000};
constexpr Scale kSigned{.is_signed = true}, kSignedTimes100{.multiplier = 100, .is_signed = true};
constexpr Scale kFirmware{.divisor = 10000};

// clang-format off
constexpr std::array kMap{
    RegisterRow{40100, 40109, ReceivedWord, ReadWrite, 2050, {}, "received process data, as they act"},
    RegisterRow{40110, 40119, SentWord, Read, 2053, {}, "sent process data"},
    RegisterRow{40300, 40300, AxisParameter, Read, 200, {}, "power unit code number"},
    RegisterRow{40301, 40301, UnitParameter, Read, 18, kFirmware, "firmware version"},
    RegisterRow{40320, 40320, AxisParameter, Read, 206, kTimes100, "rated power of the power unit (kW)"},
    RegisterRow{40321, 40321, AxisParameter, ReadWrite, 640, kTimes10, "current limit (A)"},
    RegisterRow{40322, 40322, AxisParameter, ReadWrite, 1120, kTimes100, "ramp-up time (s), with setpoint channel"},
    RegisterRow{40323, 40323, AxisParameter, ReadWrite, 1121, kTimes100, "ramp-down time (s), with setpoint channel"},
    RegisterRow{40324, 40324, AxisParameter, ReadWrite, 2000, {}, "reference speed (rpm)"},
    RegisterRow{40340, 40340, AxisParameter, Read, 20, kSigned, "speed setpoint (rpm)"},
    RegisterRow{40341, 40341, AxisParameter, Read, 21, kSigned, "speed (rpm)"},
    RegisterRow{40342, 40342, AxisParameter, Read, 24, kSignedTimes100, "output frequency (Hz)"},
    RegisterRow{40343, 40343, AxisParameter, Read, 25, {}, "output voltage (V)"},
    RegisterRow{40344, 40344, AxisParameter, Read, 26, {}, "DC link voltage (V)"},
    RegisterRow{40345, 40345, AxisParameter, Read, 27, kTimes100, "current (A)"},
    RegisterRow{40347, 40347, AxisParameter, Read, 32, kTimes100, "active power (kW)"},
    RegisterRow{40349, 40349, AxisParameter, Read, 807, {}, "control priority"},
    RegisterRow{40400, 40407, AxisParameter, Read, 947, {}, "faults, the newest first"},
    RegisterRow{40408, 40408, AxisParameter, Read, 2110, {}, "newest alarm of the buffer"},
    RegisterRow{40409, 40409, AxisParameter, Read, 2132, {}, "current alarm"},
    RegisterRow{40499, 40499, RefusalCode, Read, 0, {}, "PRM ERROR: code of the last refused access"},
    RegisterRow{40500, 40500, Technology, ReadWrite, 2200, {}, "technology controller on; reads r2349.0"},
    RegisterRow{40501, 40501, Technology, ReadWrite, 2240, kSignedTimes100, "motorized potentiometer"},
    RegisterRow{40510, 40510, Technology, ReadWrite, 2265, kTimes100, "actual value filter"},
    RegisterRow{40511, 40511, Technology, ReadWrite, 2269, kTimes100, "actual value gain"},
    RegisterRow{40512, 40512, Technology, ReadWrite, 2280, kTimes1000, "proportional gain"},
    RegisterRow{40513, 40513, Technology, ReadWrite, 2285, {}, "integral time"},
    RegisterRow{40514, 40514, Technology, ReadWrite, 2274, {}, "differentiation time"},
    RegisterRow{40515, 40515, Technology, ReadWrite, 2291, kSignedTimes100, "upper limit"},
    RegisterRow{40516, 40516, Technology, ReadWrite, 2292, kSignedTimes100, "lower limit"},
    RegisterRow{40520, 40520, Technology, Read, 2250, kSignedTimes100, "setpoint"},
    RegisterRow{40521, 40521, Technology, Read, 2266, kSignedTimes100, "actual value"},
    RegisterRow{40522, 40522, Technology, Read, 2294, kSignedTimes100, "output"},
    RegisterRow{40601, 40722, Record, ReadWrite, 0, {}, "records (DS47): control, function and length, data"},
};
// clang-format on

static_assert([] {
  std::uint16_t last = kFirstRegister - 1;
  for (const RegisterRow& row : kMap) {
    if (row.first <= last || row.last < row.first) return false;
    last = row.last;
  }
  return last == kLastRegister;
}());

/// The ends of what a register can show.
struct Ends {
  double lowest, highest;
};
template <class Integer>
constexpr Ends kEnds{std::numeric_limits<Integer>::min(), std::numeric_limits<Integer>::max()};

}  // namespace

std::span<const RegisterRow> register_map() noexcept {
  return kMap;
}

const RegisterRow* find_register(std::uint16_t number) noexcept {
  const auto* const row = std::ranges::lower_bound(kMap, number, {}, &RegisterRow::last);
  return row != kMap.end() && row->first <= number ? row : nullptr;
}

std::uint16_t shown(const Scale& scale, double value) noexcept {
  const double scaled = value * scale.multiplier / scale.divisor;
  const double whole = scale.divisor == 1 ? std::round(scaled) : std::trunc(scaled);
  const Ends ends = scale.is_signed ? kEnds<std::int16_t> : kEnds<std::uint16_t>;
  if (std::isnan(whole)) return 0;
  return static_cast<std::uint16_t>(static_cast<std::int32_t>(std::clamp(whole, ends.lowest, ends.highest)));
}

double value_of(const Scale& scale, std::uint16_t shown) noexcept {
  const double whole = scale.is_signed ? static_cast<std::int16_t>(shown) : shown;
  return whole * scale.divisor / scale.multiplier;
}

}  // namespace modbus
