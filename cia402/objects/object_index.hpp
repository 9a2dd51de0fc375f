#pragma once

#include <cstddef>
#include <cstdint>

#include "generated/cia402_axis_offsets.hpp"
#include "libcanopen/base/object_index.hpp"

/// Indices of the objects of a CiA 402 device (CiA 402-2), those of an axis on axis 1. A test holds that every
/// object of the catalogue has a name here or in libcanopen.
namespace cia402::object {

using canopen::object::kCobIdEmcy;
using canopen::object::kCobIdSync;
using canopen::object::kCobIdTime;
using canopen::object::kConsumerHeartbeatTime;
using canopen::object::kCyclePeriod;
using canopen::object::kDeviceName;
using canopen::object::kDeviceType;
using canopen::object::kErrorBehaviour;
using canopen::object::kErrorField;
using canopen::object::kErrorRegister;
using canopen::object::kGuardTime;
using canopen::object::kHeartbeatTime;
using canopen::object::kIdentity;
using canopen::object::kInhibitTimeEmcy;
using canopen::object::kLifeTimeFactor;
using canopen::object::kRestoreParameters;
using canopen::object::kRpdoMapping;
using canopen::object::kRpdoParameter;
using canopen::object::kSdoServer;
using canopen::object::kSoftwareVersion;
using canopen::object::kStoreParameters;
using canopen::object::kSyncOverflow;
using canopen::object::kTpdoMapping;
using canopen::object::kTpdoParameter;
using canopen::object::kWindowLength;

inline constexpr std::uint16_t kHardwareVersion = 0x1009;
inline constexpr std::uint16_t kVerifyConfiguration = 0x1020;

inline constexpr std::uint16_t kAbortConnectionOption = 0x6007;
inline constexpr std::uint16_t kErrorCode = 0x603F;
inline constexpr std::uint16_t kControlword = 0x6040;
inline constexpr std::uint16_t kStatusword = 0x6041;
inline constexpr std::uint16_t kVlTargetVelocity = 0x6042;
inline constexpr std::uint16_t kVlVelocityDemand = 0x6043;
inline constexpr std::uint16_t kVlVelocityActual = 0x6044;
inline constexpr std::uint16_t kVlVelocityMinMaxAmount = 0x6046;
inline constexpr std::uint16_t kVlVelocityAcceleration = 0x6048;
inline constexpr std::uint16_t kVlVelocityDeceleration = 0x6049;
inline constexpr std::uint16_t kQuickStopOption = 0x605A;
inline constexpr std::uint16_t kShutdownOption = 0x605B;
inline constexpr std::uint16_t kDisableOperationOption = 0x605C;
inline constexpr std::uint16_t kHaltOption = 0x605D;
inline constexpr std::uint16_t kFaultReactionOption = 0x605E;
inline constexpr std::uint16_t kModesOfOperation = 0x6060;
inline constexpr std::uint16_t kModesOfOperationDisplay = 0x6061;
inline constexpr std::uint16_t kPositionDemand = 0x6062;
inline constexpr std::uint16_t kPositionActualInternal = 0x6063;
inline constexpr std::uint16_t kPositionActual = 0x6064;
inline constexpr std::uint16_t kFollowingErrorWindow = 0x6065;
inline constexpr std::uint16_t kFollowingErrorTimeOut = 0x6066;
inline constexpr std::uint16_t kPositionWindow = 0x6067;
inline constexpr std::uint16_t kPositionWindowTime = 0x6068;
inline constexpr std::uint16_t kSensorSelection = 0x606A;
inline constexpr std::uint16_t kVelocityDemand = 0x606B;
inline constexpr std::uint16_t kVelocityActual = 0x606C;
inline constexpr std::uint16_t kVelocityWindow = 0x606D;
inline constexpr std::uint16_t kVelocityWindowTime = 0x606E;
inline constexpr std::uint16_t kVelocityThreshold = 0x606F;
inline constexpr std::uint16_t kVelocityThresholdTime = 0x6070;
inline constexpr std::uint16_t kTargetTorque = 0x6071;
inline constexpr std::uint16_t kMaxTorque = 0x6072;
inline constexpr std::uint16_t kMaxCurrent = 0x6073;
inline constexpr std::uint16_t kTorqueDemand = 0x6074;
inline constexpr std::uint16_t kMotorRatedCurrent = 0x6075;
inline constexpr std::uint16_t kMotorRatedTorque = 0x6076;
inline constexpr std::uint16_t kTorqueActual = 0x6077;
inline constexpr std::uint16_t kCurrentActual = 0x6078;
inline constexpr std::uint16_t kDcLinkVoltage = 0x6079;
inline constexpr std::uint16_t kTargetPosition = 0x607A;
inline constexpr std::uint16_t kPositionRangeLimit = 0x607B;
inline constexpr std::uint16_t kHomeOffset = 0x607C;
inline constexpr std::uint16_t kSoftwarePositionLimit = 0x607D;
inline constexpr std::uint16_t kPolarity = 0x607E;
inline constexpr std::uint16_t kMaxProfileVelocity = 0x607F;
inline constexpr std::uint16_t kMaxMotorSpeed = 0x6080;
inline constexpr std::uint16_t kProfileVelocity = 0x6081;
inline constexpr std::uint16_t kEndVelocity = 0x6082;
inline constexpr std::uint16_t kProfileAcceleration = 0x6083;
inline constexpr std::uint16_t kProfileDeceleration = 0x6084;
inline constexpr std::uint16_t kQuickStopDeceleration = 0x6085;
inline constexpr std::uint16_t kMotionProfileType = 0x6086;
inline constexpr std::uint16_t kTorqueSlope = 0x6087;
inline constexpr std::uint16_t kTorqueProfileType = 0x6088;
inline constexpr std::uint16_t kPositionEncoderResolution = 0x608F;
inline constexpr std::uint16_t kGearRatio = 0x6091;
inline constexpr std::uint16_t kFeedConstant = 0x6092;
inline constexpr std::uint16_t kHomingMethod = 0x6098;
inline constexpr std::uint16_t kHomingSpeeds = 0x6099;
inline constexpr std::uint16_t kHomingAcceleration = 0x609A;
inline constexpr std::uint16_t kProfileJerk = 0x60A4;
inline constexpr std::uint16_t kSiUnitPosition = 0x60A8;
inline constexpr std::uint16_t kSiUnitVelocity = 0x60A9;
inline constexpr std::uint16_t kPositionOffset = 0x60B0;
inline constexpr std::uint16_t kVelocityOffset = 0x60B1;
inline constexpr std::uint16_t kTorqueOffset = 0x60B2;
inline constexpr std::uint16_t kTouchProbeFunction = 0x60B8;
inline constexpr std::uint16_t kTouchProbeStatus = 0x60B9;
inline constexpr std::uint16_t kTouchProbe1PositiveEdge = 0x60BA;
inline constexpr std::uint16_t kTouchProbe1NegativeEdge = 0x60BB;
inline constexpr std::uint16_t kTouchProbe2PositiveEdge = 0x60BC;
inline constexpr std::uint16_t kTouchProbe2NegativeEdge = 0x60BD;
inline constexpr std::uint16_t kInterpolationSubMode = 0x60C0;
inline constexpr std::uint16_t kInterpolationData = 0x60C1;
inline constexpr std::uint16_t kInterpolationTimePeriod = 0x60C2;
inline constexpr std::uint16_t kInterpolationDataConfiguration = 0x60C4;
inline constexpr std::uint16_t kMaxAcceleration = 0x60C5;
inline constexpr std::uint16_t kMaxDeceleration = 0x60C6;
inline constexpr std::uint16_t kTouchProbeSource = 0x60D0;
inline constexpr std::uint16_t kTouchProbe1PositiveTime = 0x60D1;
inline constexpr std::uint16_t kTouchProbe1NegativeTime = 0x60D2;
inline constexpr std::uint16_t kTouchProbe2PositiveTime = 0x60D3;
inline constexpr std::uint16_t kTouchProbe2NegativeTime = 0x60D4;
inline constexpr std::uint16_t kTouchProbe1PositiveCounter = 0x60D5;
inline constexpr std::uint16_t kTouchProbe1NegativeCounter = 0x60D6;
inline constexpr std::uint16_t kTouchProbe2PositiveCounter = 0x60D7;
inline constexpr std::uint16_t kTouchProbe2NegativeCounter = 0x60D8;
inline constexpr std::uint16_t kPositiveTorqueLimit = 0x60E0;
inline constexpr std::uint16_t kNegativeTorqueLimit = 0x60E1;
inline constexpr std::uint16_t kSupportedHomingMethods = 0x60E3;
inline constexpr std::uint16_t kPositioningOption = 0x60F2;
inline constexpr std::uint16_t kFollowingErrorActual = 0x60F4;
inline constexpr std::uint16_t kControlEffort = 0x60FA;
inline constexpr std::uint16_t kPositionDemandInternal = 0x60FC;
inline constexpr std::uint16_t kDigitalInputs = 0x60FD;
inline constexpr std::uint16_t kDigitalOutputs = 0x60FE;
inline constexpr std::uint16_t kTargetVelocity = 0x60FF;
inline constexpr std::uint16_t kMotorType = 0x6402;
inline constexpr std::uint16_t kMotorCatalogueNumber = 0x6403;
inline constexpr std::uint16_t kSupportedDriveModes = 0x6502;
inline constexpr std::uint16_t kDriveCatalogueNumber = 0x6503;
inline constexpr std::uint16_t kSingleDeviceType = 0x67FF;

inline constexpr std::uint16_t kFirstProfileObject = 0x6000;
inline constexpr std::uint16_t kProfileStride = eds::stride_of(generated::kAxisOffsets, kFirstProfileObject);

/// PDOs of an axis each way: kRpdoParameter, kRpdoMapping, kTpdoParameter and kTpdoMapping begin so many records.
inline constexpr std::uint16_t kPdosPerAxis = 8;

/// The object @p index of axis 1 on axis @p axis (1..generated::kMostAxes); what the device has once stays where
/// it is.
constexpr std::uint16_t index_on_axis(std::uint16_t index, std::size_t axis) noexcept {
  return static_cast<std::uint16_t>(index + eds::axis_offset(generated::kAxisOffsets, index, axis));
}
/// The axis (from 1) that the profile object @p index (kFirstProfileObject and on) belongs to.
constexpr std::size_t axis_of(std::uint16_t index) noexcept {
  return 1 + static_cast<std::size_t>(index - kFirstProfileObject) / kProfileStride;
}
/// The same profile object on axis 1.
constexpr std::uint16_t index_on_first_axis(std::uint16_t index) noexcept {
  return static_cast<std::uint16_t>(kFirstProfileObject + (index - kFirstProfileObject) % kProfileStride);
}

}  // namespace cia402::object
