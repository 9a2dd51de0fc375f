#include "cia402/drive/drive_link.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "drive/parameter/bico.hpp"

namespace cia402 {
namespace {

/// Words of the process data (r8850, r8860), and their bits.
enum Place : std::uint16_t {
  kControlword = 0,
  kModes = 1,
  kSpeed = 2,
  kTorque = 4,
  kOffset = 6,
  kUpper = 8,
  kLower = 10
};
enum ControlBit : std::uint16_t { kOn = 0, kNoOff2 = 1, kNoOff3 = 2, kEnable = 3, kAcknowledge = 7 };
enum ModeBit : std::uint16_t { kTorqueControl = 0 };

constexpr std::uint16_t kDoubleWord = 8860;
constexpr std::uint16_t kFirstBits = 8890;

/// An input of the drive and the word, or bit of one, that it follows.
struct Wire {
  std::uint16_t input;
  std::uint16_t source;
  std::uint16_t position;
};
constexpr std::array kWires{Wire{840, kFirstBits + kControlword, kOn},
                            Wire{844, kFirstBits + kControlword, kNoOff2},
                            Wire{848, kFirstBits + kControlword, kNoOff3},
                            Wire{852, kFirstBits + kControlword, kEnable},
                            Wire{2103, kFirstBits + kControlword, kAcknowledge},
                            Wire{1501, kFirstBits + kModes, kTorqueControl},
                            Wire{1155, kDoubleWord, kSpeed},
                            Wire{1503, kDoubleWord, kTorque},
                            Wire{1511, kDoubleWord, kOffset},
                            Wire{1522, kDoubleWord, kUpper},
                            Wire{1523, kDoubleWord, kLower}};

constexpr std::uint16_t kControlMode = 1300;
constexpr double kSpeedControlWithEncoder = 21.0;
constexpr std::uint16_t kConnectStandardObjects = 8790;
constexpr std::uint16_t kMainSetpoint = 1070;
constexpr std::uint16_t kProcessDataCycle = 8848;
constexpr double kCycleMs = 1.0;

/// 100 % in a double word.
constexpr double kWhole = 0x40000000;

constexpr std::uint16_t controlword_of(Power power) noexcept {
  constexpr unsigned kReady = 1U << kNoOff2 | 1U << kNoOff3 | 1U << kEnable;
  constexpr std::array<unsigned, 3> kOf{0U, kReady, kReady | 1U << kOn};
  return static_cast<std::uint16_t>(kOf[static_cast<std::size_t>(power)]);
}

}  // namespace

void DriveLink::set(std::size_t place, double share) noexcept {
  constexpr double kLow = -0x80000000LL;
  constexpr double kHigh = 0x7FFFFFFF;
  const double word = std::clamp(std::round(share * kWhole), kLow, kHigh);
  drive::ProcessDataImage::set_double_word(axis_.process_data().received, place,
                                           static_cast<std::uint32_t>(static_cast<std::int32_t>(word)));
}

void DriveLink::bring(const DriveCommand& command) noexcept {
  const drive::References& references = axis_.references();
  auto& words = axis_.process_data().received;
  axis_.block<drive::HoldingBrake>().hold(command.holds_brake);
  const bool rises = command.power == Power::On && last_ == Power::Off;
  last_ = rises ? Power::Stop : command.power;
  words[kControlword] = controlword_of(last_);
  words[kModes] = static_cast<std::uint16_t>(command.torque_control ? 1U << kTorqueControl : 0U);
  set(kSpeed, command.speed / references.speed);
  set(kTorque, command.torque / references.torque);
  set(kOffset, command.torque_offset / references.torque);
  set(kUpper, command.upper_torque / references.torque);
  set(kLower, command.lower_torque / references.torque);
}

std::vector<unit::ParameterPreset> drive_presets() {
  std::vector<unit::ParameterPreset> presets{
      {kConnectStandardObjects, 0.0}, {kControlMode, kSpeedControlWithEncoder}, {kMainSetpoint, 0.0}};
  for (const Wire& wire : kWires) presets.push_back({wire.input, drive::own_source(wire.source, wire.position)});
  return presets;
}

std::vector<unit::ParameterPreset> control_unit_presets() {
  return {{kProcessDataCycle, kCycleMs}};
}

}  // namespace cia402
