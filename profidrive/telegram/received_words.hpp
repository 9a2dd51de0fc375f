#pragma once

#include <array>

#include "profidrive/telegram/telegram.hpp"

/// The words that controllers send, each with the inputs that it leads to.
namespace profidrive::received {

using enum Sink::Part;

// clang-format off
inline constexpr std::array kStateMachine{
    Sink{840, Bit, 0},   // ON
    Sink{844, Bit, 1},   // no OFF2
    Sink{848, Bit, 2},   // no OFF3
    Sink{852, Bit, 3},   // enable operation
    Sink{2103, Bit, 7},  // acknowledge
    Sink{854, Bit, 10},  // control by PLC
};
inline constexpr std::array kRamp{
    Sink{1140, Bit, 4},   // ramp enabled
    Sink{1141, Bit, 5},   // ramp runs
    Sink{1142, Bit, 6},   // setpoint enabled
    Sink{1113, Bit, 11},  // reverse
};
inline constexpr std::array kPotentiometer{
    Sink{1035, Bit, 13},  // raise
    Sink{1036, Bit, 14},  // lower
};
inline constexpr std::array kPotentiometerAndDataSet{
    Sink{1035, Bit, 13},  // raise
    Sink{1036, Bit, 14},  // lower
    Sink{810, Bit, 15},   // command data set
};
inline constexpr std::array kBrakeAndTorqueControl{
    Sink{855, Bit, 12},   // open the brake
    Sink{1501, Bit, 14},  // torque control
};
inline constexpr std::array kPositioner{
    Sink{2641, Bit, 4},   // do not reject
    Sink{2640, Bit, 5},   // no intermediate stop
    Sink{2631, Bit, 6},   // activate block
    Sink{2650, Bit, 6},   // accept setpoints
    Sink{2589, Bit, 8},   // jog 1
    Sink{2590, Bit, 9},   // jog 2
    Sink{2595, Bit, 11},  // referencing
    Sink{2633, Bit, 13},  // external block change
};
inline constexpr std::array kStw2{
    Sink{820, Bit, 0},   // drive data set
    Sink{821, Bit, 1},
    Sink{822, Bit, 2},
    Sink{823, Bit, 3},
    Sink{824, Bit, 4},
    Sink{897, Bit, 7},   // parking axis
    Sink{1545, Bit, 8},  // travel to fixed stop
    Sink{828, Bit, 11},  // motor changed over
    Sink{2045, Word},    // sign of life
};
/// Of the telegrams from 102 on.
inline constexpr std::array kStw2OfMode1{
    Sink{820, Bit, 0},   // drive data set
    Sink{821, Bit, 1},
    Sink{822, Bit, 2},
    Sink{1477, Bit, 6},  // hold the integrator
    Sink{1545, Bit, 8},  // travel to fixed stop
    Sink{823, Bit, 9},   // drive data set, bit 3
    Sink{2045, Word},    // sign of life
};
inline constexpr std::array kStw3{
    Sink{1020, Bit, 0},   // fixed setpoint
    Sink{1021, Bit, 1},
    Sink{1022, Bit, 2},
    Sink{1023, Bit, 3},
    Sink{820, Bit, 4},    // drive data set
    Sink{821, Bit, 5},
    Sink{2200, Bit, 8},   // technology controller
    Sink{1230, Bit, 9},   // DC brake
    Sink{1492, Bit, 11},  // droop
    Sink{1501, Bit, 12},  // torque control
    Sink{2106, Bit, 13},  // external fault
    Sink{811, Bit, 15},   // command data set
};
inline constexpr std::array kNsollA{
    Sink{1070, Word, 0, 0, SetpointChannel::With},
    Sink{1155, Word, 0, 0, SetpointChannel::Without},
};
inline constexpr std::array kNsollB{
    Sink{1070, DoubleWord, 0, 0, SetpointChannel::With},
    Sink{1155, DoubleWord, 0, 0, SetpointChannel::Without},
};
inline constexpr std::array kTorqueReduction{Sink{1542, Word}};
inline constexpr std::array kTorqueLimits{Sink{1552, Word}, Sink{1554, Word}};
inline constexpr std::array kEncoder1{Sink{480, Word, 0, 0}};
inline constexpr std::array kEncoder2{Sink{480, Word, 0, 1}};
inline constexpr std::array kPositionDeviation{Sink{1190, DoubleWord}};
inline constexpr std::array kPositionGain{Sink{1191, DoubleWord}};

inline constexpr std::array kBlockNumber{
    Sink{2625, Bit, 0}, Sink{2626, Bit, 1}, Sink{2627, Bit, 2}, Sink{2628, Bit, 3}, Sink{2629, Bit, 4}, Sink{2630, Bit, 5},
};
inline constexpr std::array kMdiSelection{Sink{2647, Bit, 15}};
inline constexpr std::array kMdiBits{
    Sink{2648, Bit, 8},   // absolute
    Sink{2651, Bit, 9},   // positive direction
    Sink{2652, Bit, 10},  // negative direction
    Sink{2649, Bit, 12},  // continuous transfer
    Sink{2653, Bit, 14},  // setting-up
};
inline constexpr std::array kPosStw{
    Sink{2655, Bit, 0},  // tracking
    Sink{2596, Bit, 1},  // set reference point
    Sink{2612, Bit, 2},  // reference cam
    Sink{2591, Bit, 5},  // jog incremental
};
inline constexpr std::array kPosStw2{
    Sink{2597, Bit, 8},   // flying referencing
    Sink{2604, Bit, 9},   // search in negative direction
    Sink{2510, Bit, 10},  // probe 2
    Sink{2511, Bit, 11},  // falling edge
    Sink{2582, Bit, 14},  // software limits
    Sink{2568, Bit, 15},  // STOP cams
};
inline constexpr std::array kOverride{Sink{2646, Word}};
inline constexpr std::array kTarget{Sink{2642, DoubleWord}};
inline constexpr std::array kVelocity{Sink{2643, DoubleWord}};
inline constexpr std::array kAcceleration{Sink{2644, Word}};
inline constexpr std::array kDeceleration{Sink{2645, Word}};
inline constexpr std::array kMdiMode{
    Sink{2099, Word},
    Sink{2648, FirstConverter, 0},  // absolute
    Sink{2651, FirstConverter, 1},  // positive direction
    Sink{2652, FirstConverter, 2},  // negative direction
};

inline constexpr std::array kControlUnit{
    Sink{681, Bit, 0},    // synchronisation of probes
    Sink{3104, Bit, 1},   // ping
    Sink{2103, Bit, 7},   // acknowledge
    Sink{3116, Bit, 10},  // no automatic acknowledgement
    Sink{2045, Word},     // sign of life
};
inline constexpr std::array kDigitalOutputs{
    Sink{738, Bit, 0}, Sink{739, Bit, 1}, Sink{740, Bit, 2}, Sink{741, Bit, 3},
    Sink{742, Bit, 4}, Sink{743, Bit, 5}, Sink{744, Bit, 6}, Sink{745, Bit, 7},
};
// clang-format on

inline constexpr ReceivedWord kStw1{.name = "STW1", .sinks = {kStateMachine, kRamp, kPotentiometer}};
inline constexpr ReceivedWord kStw1OfMode1{.name = "STW1",
                                           .sinks = {kStateMachine, kRamp, kBrakeAndTorqueControl}};
inline constexpr ReceivedWord kStw1OfNamur{.name = "STW1",
                                           .sinks = {kStateMachine, kRamp, kPotentiometerAndDataSet}};
inline constexpr ReceivedWord kStw1OfPositioner{.name = "STW1", .sinks = {kStateMachine, kPositioner}};
inline constexpr ReceivedWord kStw2Word{.name = "STW2", .sinks = {kStw2}, .has_sign_of_life = true};
inline constexpr ReceivedWord kStw2WordOfMode1{.name = "STW2", .sinks = {kStw2OfMode1}, .has_sign_of_life = true};
inline constexpr ReceivedWord kStw3Word{.name = "STW3", .sinks = {kStw3}};
inline constexpr ReceivedWord kSpeed{.name = "NSOLL_A", .sinks = {kNsollA}};
inline constexpr ReceivedWord kFineSpeed{.name = "NSOLL_B", .words = 2, .sinks = {kNsollB}};
inline constexpr ReceivedWord kMomred{.name = "MOMRED", .sinks = {kTorqueReduction}};
inline constexpr ReceivedWord kTorqueLimit{.name = "M_LIM", .sinks = {kTorqueLimits}};
inline constexpr ReceivedWord kEncoderControl1{.name = "G1_STW", .sinks = {kEncoder1}};
inline constexpr ReceivedWord kEncoderControl2{.name = "G2_STW", .sinks = {kEncoder2}};
inline constexpr ReceivedWord kXerr{.name = "XERR", .words = 2, .sinks = {kPositionDeviation}};
inline constexpr ReceivedWord kKpc{.name = "KPC", .words = 2, .sinks = {kPositionGain}};
inline constexpr ReceivedWord kFree{.name = "free", .is_free = true};

inline constexpr ReceivedWord kSatzanw{.name = "SATZANW", .sinks = {kBlockNumber, kMdiSelection}};
inline constexpr ReceivedWord kPosStwWord{.name = "POS_STW", .sinks = {kPosStw}};
inline constexpr ReceivedWord kPosStw1Word{.name = "POS_STW1", .sinks = {kBlockNumber, kMdiSelection, kMdiBits}};
inline constexpr ReceivedWord kPosStw2Word{.name = "POS_STW2", .sinks = {kPosStw, kPosStw2}};
inline constexpr ReceivedWord kOverrideWord{.name = "OVERRIDE", .sinks = {kOverride}};
inline constexpr ReceivedWord kMdiTarget{.name = "MDI_TARPOS", .words = 2, .sinks = {kTarget}};
inline constexpr ReceivedWord kMdiVelocity{.name = "MDI_VELOCITY", .words = 2, .sinks = {kVelocity}};
inline constexpr ReceivedWord kMdiAcceleration{.name = "MDI_ACC", .sinks = {kAcceleration}};
inline constexpr ReceivedWord kMdiDeceleration{.name = "MDI_DEC", .sinks = {kDeceleration}};
inline constexpr ReceivedWord kMdiModeWord{.name = "MDI_MOD", .sinks = {kMdiMode}};

inline constexpr ReceivedWord kCuStw1{.name = "CU_STW1", .sinks = {kControlUnit}, .has_sign_of_life = true};
inline constexpr ReceivedWord kADigital{.name = "A_DIGITAL", .sinks = {kDigitalOutputs}};
/// A word that leads nowhere: probes are not simulated.
inline constexpr ReceivedWord kMtStw{.name = "MT_STW"};
inline constexpr ReceivedWord kADigital1{.name = "A_DIGITAL_1"};

}  // namespace profidrive::received
