#pragma once

#include "profidrive/telegram/telegram.hpp"

/// The words that drive objects send, each with what it shows.
namespace profidrive::sent {

// clang-format off
inline constexpr StatusBits kZsw1Bits{{
    {899, 0},         // ready for switching on
    {899, 1},         // ready
    {899, 2},         // operation enabled
    {2139, 3},        // fault
    {899, 4},         // OFF2 not active
    {899, 5},         // OFF3 not active
    {899, 6},         // switching on inhibited
    {2139, 7},        // alarm
    {2197, 7},        // speed deviation in tolerance
    {899, 9},         // control requested
    {2199, 1},        // comparison speed reached
    {1407, 7, true},  // torque limit not reached
    {899, 12},        // brake open
    {2135, 14, true}, // no motor overtemperature
    {2197, 3},        // positive speed
    {2135, 15, true}, // no thermal overload of the power unit
}};
/// Of the telegrams from 102 on.
inline constexpr StatusBits kZsw1BitsOfMode1{{
    {899, 0}, {899, 1}, {899, 2}, {2139, 3}, {899, 4}, {899, 5}, {899, 6}, {2139, 7}, {2197, 7}, {899, 9}, {2199, 1},
    {2139, 11}, {2139, 12},  // alarm class
    {},
    {1407, 2},               // torque control
    {},
}};
inline constexpr StatusBits kZsw1BitsOfNamur{{
    {899, 0}, {899, 1}, {899, 2}, {2139, 3}, {899, 4}, {899, 5}, {899, 6}, {2139, 7}, {2197, 7}, {899, 9}, {2199, 1},
    {56, 13},                // current or torque limit
    {899, 12},               // brake open
    {2135, 14, true},        // no motor overtemperature
    {2197, 3},               // positive speed
    {836, 0},                // command data set
}};
inline constexpr StatusBits kZsw1BitsOfPositioner{{
    {899, 0}, {899, 1}, {899, 2}, {2139, 3}, {899, 4}, {899, 5}, {899, 6}, {2139, 7},
    {2684, 8},               // following error in tolerance
    {899, 9},
    {2684, 10},              // target position reached
    {2684, 11},              // reference point set
    {2684, 12},              // block or MDI acknowledged
    {2199, 0},               // stands
    {2684, 4},               // setpoint moves forward
    {2684, 5},               // setpoint moves backward
}};
inline constexpr StatusBits kZsw2Bits{{
    {51, 0}, {51, 1}, {51, 2}, {51, 3}, {51, 4},  // drive data set
    {2139, 11}, {2139, 12},                       // alarm class
    {896, 0},                                     // parking axis
    {1406, 8},                                    // travel to fixed stop
    {},
    {899, 11},                                    // pulses enabled
    {835, 0},                                     // data set is changed
    {}, {}, {}, {},
}};
inline constexpr StatusBits kZsw2BitsOfMode1{{
    {51, 0}, {51, 1}, {51, 2}, {51, 3},           // drive data set
    {1199, 2},                                    // ramp inactive
    {899, 12},                                    // brake open
    {1407, 5},                                    // integrator held
    {896, 0},                                     // parking axis
    {1406, 8},                                    // travel to fixed stop
    {},
    {899, 11},                                    // pulses enabled
    {835, 0},                                     // data set is changed
    {}, {}, {}, {},
}};
inline constexpr StatusBits kMeldwBits{{
    {2199, 5},         // ramp finished
    {2199, 11},        // torque utilisation below its threshold
    {2199, 0},         // speed below p2161
    {2197, 1},         // speed at or below p2155
    {},
    {3294, 0},         // variable signalling function
    {2135, 14, true},  // no motor overtemperature
    {2135, 15, true},  // no thermal overload of the power unit
    {2199, 4},         // speed deviation in tolerance
    {}, {},
    {899, 8},          // controller enabled
    {899, 7},          // drive ready
    {899, 11},         // pulses enabled
    {}, {},
}};
inline constexpr StatusBits kAktsatzBits{{
    {2670, 0}, {2670, 1}, {2670, 2}, {2670, 3}, {2670, 4}, {2670, 5}, {}, {}, {}, {}, {}, {}, {}, {}, {}, {2670, 15},
}};
inline constexpr StatusBits kPosZswBits{{
    {2683, 0}, {2683, 1}, {2683, 2}, {2683, 3}, {2683, 4}, {2683, 5}, {2683, 6}, {2683, 7}, {}, {}, {}, {}, {}, {}, {}, {},
}};
inline constexpr StatusBits kPosZsw1Bits{{
    {2670, 0}, {2670, 1}, {2670, 2}, {2670, 3}, {2670, 4}, {2670, 5}, {}, {},
    {2684, 13}, {2684, 14},          // STOP cams
    {2094, 0}, {2094, 1},            // jogging, referencing
    {2684, 1},                       // flying referencing
    {2094, 2}, {2094, 4},            // traversing blocks, setting-up
    {2670, 15},
}};
inline constexpr StatusBits kPosZsw2Bits{{
    {2683, 0}, {2683, 1}, {2683, 2}, {2684, 3}, {2683, 4}, {2683, 5}, {2683, 6}, {2683, 7},
    {2683, 8}, {2683, 9}, {2683, 10}, {2683, 11}, {2683, 12}, {2683, 13}, {2683, 14}, {2684, 15},
}};
inline constexpr StatusBits kCuZsw1Bits{{
    {}, {}, {}, {2139, 3}, {}, {}, {}, {2139, 7}, {}, {}, {}, {}, {}, {}, {}, {},
}};
/// DI/DO 8 to 15 and DI 0 to 7.
inline constexpr StatusBits kEDigitalBits{{
    {722, 8}, {722, 9}, {722, 10}, {722, 11}, {722, 12}, {722, 13}, {722, 14}, {722, 15},
    {722, 0}, {722, 1}, {722, 2}, {722, 3}, {722, 4}, {722, 5}, {722, 6}, {722, 7},
}};
// clang-format on

// Where status words are made of bits.
inline constexpr std::uint8_t kFirst = 0, kSecond = 1, kThird = 2, kFourth = 3, kFifth = 4;

inline constexpr SentWord kZsw1{.name = "ZSW1", .bits = &kZsw1Bits, .converter = kFirst};
inline constexpr SentWord kZsw1OfMode1{.name = "ZSW1", .bits = &kZsw1BitsOfMode1, .converter = kFirst};
inline constexpr SentWord kZsw1OfNamur{.name = "ZSW1", .bits = &kZsw1BitsOfNamur, .converter = kFirst};
inline constexpr SentWord kZsw1OfPositioner{.name = "ZSW1", .bits = &kZsw1BitsOfPositioner, .converter = kFirst};
inline constexpr SentWord kZsw2{
    .name = "ZSW2", .bits = &kZsw2Bits, .converter = kSecond, .has_sign_of_life = true};
inline constexpr SentWord kZsw2OfMode1{
    .name = "ZSW2", .bits = &kZsw2BitsOfMode1, .converter = kSecond, .has_sign_of_life = true};
inline constexpr SentWord kMeldw{.name = "MELDW", .bits = &kMeldwBits, .converter = kThird};
inline constexpr SentWord kZsw3{.name = "ZSW3", .source = 53};
inline constexpr SentWord kSpeed{.name = "NIST_A", .source = 63};
inline constexpr SentWord kFineSpeed{.name = "NIST_B", .words = 2, .source = 63};
inline constexpr SentWord kSmoothSpeed{.name = "NIST_A_GLATT", .source = 63, .index = 1};
inline constexpr SentWord kCurrent{.name = "IAIST_GLATT", .source = 68, .index = 1};
inline constexpr SentWord kTorque{.name = "MIST_GLATT", .source = 80, .index = 1};
inline constexpr SentWord kPower{.name = "PIST_GLATT", .source = 82, .index = 1};
inline constexpr SentWord kNamur{.name = "MELD_NAMUR", .source = 3113, .is_free = true};
inline constexpr SentWord kAlarm{.name = "WARN_CODE", .source = 2132};
inline constexpr SentWord kFault{.name = "FAULT_CODE", .source = 2131};
inline constexpr SentWord kEncoderStatus1{.name = "G1_ZSW", .source = 481};
inline constexpr SentWord kEncoderPosition1{.name = "G1_XIST1", .words = 2, .source = 482};
inline constexpr SentWord kEncoderValue1{.name = "G1_XIST2", .words = 2, .source = 483};
inline constexpr SentWord kEncoderStatus2{.name = "G2_ZSW", .source = 481, .index = 1};
inline constexpr SentWord kEncoderPosition2{.name = "G2_XIST1", .words = 2, .source = 482, .index = 1};
inline constexpr SentWord kEncoderValue2{.name = "G2_XIST2", .words = 2, .source = 483, .index = 1};
inline constexpr SentWord kUtilisation{.name = "r0081", .source = 81};
inline constexpr SentWord kTorqueSetpoint{.name = "r0079", .source = 79};
inline constexpr SentWord kActivePower{.name = "r0082", .source = 82};
inline constexpr SentWord kTorqueCurrent{.name = "r0078", .source = 78};
inline constexpr SentWord kFree{.name = "free", .is_free = true};

inline constexpr SentWord kAktsatz{.name = "AKTSATZ", .bits = &kAktsatzBits, .converter = kFourth};
inline constexpr SentWord kPosZsw{.name = "POS_ZSW", .bits = &kPosZswBits, .converter = kFifth};
inline constexpr SentWord kPosZsw1{
    .name = "POS_ZSW1", .bits = &kPosZsw1Bits, .converter = kFourth, .converted = 2669};
inline constexpr SentWord kPosZsw2{.name = "POS_ZSW2", .bits = &kPosZsw2Bits, .converter = kFifth};
inline constexpr SentWord kPosition{.name = "XIST_A", .words = 2, .source = 2521};

inline constexpr SentWord kCuZsw1{.name = "CU_ZSW1",
                                  .bits = &kCuZsw1Bits,
                                  .converter = kFirst,
                                  .has_sign_of_life = true,
                                  .shows_synchronised = true};
inline constexpr SentWord kEDigital{.name = "E_DIGITAL", .bits = &kEDigitalBits, .converter = kSecond};
/// Words that are 0: probes and further terminals are not simulated.
inline constexpr SentWord kMtZsw{.name = "MT_ZSW"};
inline constexpr SentWord kMt1Falling{.name = "MT1_ZS_F"};
inline constexpr SentWord kMt1Rising{.name = "MT1_ZS_S"};
inline constexpr SentWord kMt2Falling{.name = "MT2_ZS_F"};
inline constexpr SentWord kMt2Rising{.name = "MT2_ZS_S"};
inline constexpr SentWord kEDigital1{.name = "E_DIGITAL_1"};

}  // namespace profidrive::sent
