#pragma once

#include <array>
#include <cstdint>

#include "device/objects/object_index.hpp"
#include "drive/axis/axis.hpp"
#include "drive/base/scaling.hpp"

namespace device {

/// How a process object and its words are related.
enum class WordForm : std::uint8_t {
  Raw,     ///< as it is; an object of 8 bits is sign-extended
  Speed,   ///< increments/s in two words, of which 40000000h is p2000
  Rpm,     ///< rpm in one word, of which 4000h is p2000
  Torque,  ///< per mille of the rated torque in one word, of which 4000h is p2003
};

/// A profile object that is received, on the first axis.
struct ReceivedObject {
  std::uint16_t index;
  WordForm form;
};
inline constexpr std::array kReceivedObjects{
    ReceivedObject{object::kControlword, WordForm::Raw},
    ReceivedObject{object::kVlTargetVelocity, WordForm::Rpm},
    ReceivedObject{object::kModesOfOperation, WordForm::Raw},
    ReceivedObject{object::kTargetTorque, WordForm::Torque},
    ReceivedObject{object::kTargetVelocity, WordForm::Speed},
};

/// A profile object that is sent, on the first axis: what it shows of the axis in SI units while it is not mapped,
/// and the parameter that a new unit sends in its place (p8851, p8861).
struct SentObject {
  std::uint16_t index;
  WordForm form;
  double (*value)(const drive::ActualValues& actual) noexcept;
  std::uint16_t parameter;
};
inline constexpr std::array kSentObjects{
    SentObject{object::kStatusword, WordForm::Raw,
               [](const drive::ActualValues& a) noexcept { return static_cast<double>(a.statusword); }, 8784},
    SentObject{object::kVlVelocityDemand, WordForm::Rpm,
               [](const drive::ActualValues& a) noexcept { return a.speed_demand; }, 1170},
    SentObject{object::kVlVelocityActual, WordForm::Rpm,
               [](const drive::ActualValues& a) noexcept { return a.speed; }, 63},
    SentObject{object::kModesOfOperationDisplay, WordForm::Raw,
               [](const drive::ActualValues& a) noexcept { return static_cast<double>(a.mode); }, 8762},
    SentObject{object::kPositionActual, WordForm::Raw,
               [](const drive::ActualValues& a) noexcept { return static_cast<double>(a.encoder_position); }, 482},
    SentObject{object::kVelocitySensorActual, WordForm::Speed,
               [](const drive::ActualValues& a) noexcept { return a.speed; }, 61},
    SentObject{object::kVelocityDemand, WordForm::Speed,
               [](const drive::ActualValues& a) noexcept { return a.speed_demand; }, 1170},
    SentObject{object::kVelocityActual, WordForm::Speed,
               [](const drive::ActualValues& a) noexcept { return a.speed; }, 63},
    SentObject{object::kTorqueDemand, WordForm::Torque,
               [](const drive::ActualValues& a) noexcept { return a.torque_demand; }, 79},
    SentObject{object::kTorqueActual, WordForm::Torque,
               [](const drive::ActualValues& a) noexcept { return a.torque; }, 80},
};

/// The relations of WordForm for one axis, as its parameters are now.
class WordScaling {
 public:
  WordScaling(const drive::BusScaling& bus, const drive::References& references) noexcept
      : bus_{bus}, speed_{references.speed}, torque_{references.torque} {}

  /// The words of an object that has the value @p bus; a single one is the lower half.
  std::uint32_t words(WordForm form, std::int64_t bus) const noexcept;
  /// The value on the bus of what stands in @p words.
  std::int64_t bus(WordForm form, std::uint32_t words) const noexcept;
  /// The value on the bus of @p value in SI units.
  std::int64_t bus_of(WordForm form, double value) const noexcept;

 private:
  drive::BusScaling bus_;
  double speed_;   // p2000, rad/s
  double torque_;  // p2003, N·m
};

}  // namespace device
