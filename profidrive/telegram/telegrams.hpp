#pragma once

#include <algorithm>
#include <array>

#include "profidrive/telegram/received_words.hpp"
#include "profidrive/telegram/sent_words.hpp"

/// The telegrams that drive objects offer.
namespace profidrive::telegrams {

using Received = const ReceivedWord*;
using Sent = const SentWord*;
namespace rx = received;
namespace tx = sent;

// clang-format off
inline constexpr std::array<Received, 2> kRx1{&rx::kStw1, &rx::kSpeed};
inline constexpr std::array<Sent, 2> kTx1{&tx::kZsw1, &tx::kSpeed};
inline constexpr std::array<Received, 3> kRx2{&rx::kStw1, &rx::kFineSpeed, &rx::kStw2Word};
inline constexpr std::array<Sent, 3> kTx2{&tx::kZsw1, &tx::kFineSpeed, &tx::kZsw2};
inline constexpr std::array<Received, 4> kRx3{&rx::kStw1, &rx::kFineSpeed, &rx::kStw2Word, &rx::kEncoderControl1};
inline constexpr std::array<Sent, 6> kTx3{
    &tx::kZsw1, &tx::kFineSpeed, &tx::kZsw2, &tx::kEncoderStatus1, &tx::kEncoderPosition1, &tx::kEncoderValue1};
inline constexpr std::array<Received, 5> kRx4{
    &rx::kStw1, &rx::kFineSpeed, &rx::kStw2Word, &rx::kEncoderControl1, &rx::kEncoderControl2};
inline constexpr std::array<Sent, 9> kTx4{
    &tx::kZsw1, &tx::kFineSpeed, &tx::kZsw2, &tx::kEncoderStatus1, &tx::kEncoderPosition1, &tx::kEncoderValue1,
    &tx::kEncoderStatus2, &tx::kEncoderPosition2, &tx::kEncoderValue2};
inline constexpr std::array<Received, 6> kRx5{
    &rx::kStw1, &rx::kFineSpeed, &rx::kStw2Word, &rx::kEncoderControl1, &rx::kXerr, &rx::kKpc};
inline constexpr std::array<Received, 7> kRx6{
    &rx::kStw1, &rx::kFineSpeed, &rx::kStw2Word, &rx::kEncoderControl1, &rx::kEncoderControl2, &rx::kXerr, &rx::kKpc};
inline constexpr std::array<Received, 2> kRx7{&rx::kStw1OfPositioner, &rx::kSatzanw};
inline constexpr std::array<Sent, 2> kTx7{&tx::kZsw1OfPositioner, &tx::kAktsatz};
inline constexpr std::array<Received, 8> kRx9{
    &rx::kStw1OfPositioner, &rx::kSatzanw, &rx::kStw2Word, &rx::kMdiTarget, &rx::kMdiVelocity, &rx::kMdiAcceleration,
    &rx::kMdiDeceleration, &rx::kMdiModeWord};
inline constexpr std::array<Sent, 4> kTx9{&tx::kZsw1OfPositioner, &tx::kAktsatz, &tx::kZsw2, &tx::kPosition};
inline constexpr std::array<Received, 2> kRx20{&rx::kStw1OfNamur, &rx::kSpeed};
inline constexpr std::array<Sent, 6> kTx20{
    &tx::kZsw1OfNamur, &tx::kSmoothSpeed, &tx::kCurrent, &tx::kTorque, &tx::kPower, &tx::kNamur};
inline constexpr std::array<Received, 5> kRx102{
    &rx::kStw1OfMode1, &rx::kFineSpeed, &rx::kStw2WordOfMode1, &rx::kMomred, &rx::kEncoderControl1};
inline constexpr std::array<Sent, 7> kTx102{
    &tx::kZsw1OfMode1, &tx::kFineSpeed, &tx::kZsw2OfMode1, &tx::kMeldw, &tx::kEncoderStatus1, &tx::kEncoderPosition1,
    &tx::kEncoderValue1};
inline constexpr std::array<Received, 6> kRx103{
    &rx::kStw1OfMode1, &rx::kFineSpeed, &rx::kStw2WordOfMode1, &rx::kMomred, &rx::kEncoderControl1, &rx::kEncoderControl2};
inline constexpr std::array<Sent, 10> kTx103{
    &tx::kZsw1OfMode1, &tx::kFineSpeed, &tx::kZsw2OfMode1, &tx::kMeldw, &tx::kEncoderStatus1, &tx::kEncoderPosition1,
    &tx::kEncoderValue1, &tx::kEncoderStatus2, &tx::kEncoderPosition2, &tx::kEncoderValue2};
inline constexpr std::array<Received, 7> kRx105{
    &rx::kStw1OfMode1, &rx::kFineSpeed, &rx::kStw2WordOfMode1, &rx::kMomred, &rx::kEncoderControl1, &rx::kXerr, &rx::kKpc};
inline constexpr std::array<Received, 8> kRx106{
    &rx::kStw1OfMode1, &rx::kFineSpeed, &rx::kStw2WordOfMode1, &rx::kMomred, &rx::kEncoderControl1, &rx::kEncoderControl2,
    &rx::kXerr, &rx::kKpc};
inline constexpr std::array<Sent, 14> kTx116{
    &tx::kZsw1OfMode1, &tx::kFineSpeed, &tx::kZsw2OfMode1, &tx::kMeldw, &tx::kEncoderStatus1, &tx::kEncoderPosition1,
    &tx::kEncoderValue1, &tx::kEncoderStatus2, &tx::kEncoderPosition2, &tx::kEncoderValue2, &tx::kUtilisation,
    &tx::kTorqueSetpoint, &tx::kActivePower, &tx::kTorqueCurrent};
inline constexpr std::array<Received, 10> kRx110{
    &rx::kStw1OfPositioner, &rx::kSatzanw, &rx::kPosStwWord, &rx::kStw2Word, &rx::kOverrideWord, &rx::kMdiTarget,
    &rx::kMdiVelocity, &rx::kMdiAcceleration, &rx::kMdiDeceleration, &rx::kMdiModeWord};
inline constexpr std::array<Sent, 6> kTx110{
    &tx::kZsw1OfPositioner, &tx::kAktsatz, &tx::kPosZsw, &tx::kZsw2, &tx::kMeldw, &tx::kPosition};
inline constexpr std::array<Received, 10> kRx111{
    &rx::kStw1OfPositioner, &rx::kPosStw1Word, &rx::kPosStw2Word, &rx::kStw2Word, &rx::kOverrideWord, &rx::kMdiTarget,
    &rx::kMdiVelocity, &rx::kMdiAcceleration, &rx::kMdiDeceleration, &rx::kFree};
inline constexpr std::array<Sent, 10> kTx111{
    &tx::kZsw1OfPositioner, &tx::kPosZsw1, &tx::kPosZsw2, &tx::kZsw2, &tx::kMeldw, &tx::kPosition, &tx::kFineSpeed,
    &tx::kFault, &tx::kAlarm, &tx::kFree};
inline constexpr std::array<Received, 4> kRx350{&rx::kStw1, &rx::kSpeed, &rx::kTorqueLimit, &rx::kStw3Word};
inline constexpr std::array<Sent, 4> kTx350{&tx::kZsw1, &tx::kSmoothSpeed, &tx::kCurrent, &tx::kZsw3};
inline constexpr std::array<Received, 6> kRx352{
    &rx::kStw1, &rx::kSpeed, &rx::kFree, &rx::kFree, &rx::kFree, &rx::kFree};
inline constexpr std::array<Sent, 6> kTx352{
    &tx::kZsw1, &tx::kSmoothSpeed, &tx::kCurrent, &tx::kTorque, &tx::kAlarm, &tx::kFault};
inline constexpr std::array<Sent, 2> kTx353{&tx::kZsw1, &tx::kSmoothSpeed};
inline constexpr std::array<Received, 2> kRx390{&rx::kCuStw1, &rx::kADigital};
inline constexpr std::array<Sent, 2> kTx390{&tx::kCuZsw1, &tx::kEDigital};
inline constexpr std::array<Received, 3> kRx391{&rx::kCuStw1, &rx::kADigital, &rx::kMtStw};
inline constexpr std::array<Sent, 7> kTx391{
    &tx::kCuZsw1, &tx::kEDigital, &tx::kMtZsw, &tx::kMt1Falling, &tx::kMt1Rising, &tx::kMt2Falling, &tx::kMt2Rising};
inline constexpr std::array<Received, 3> kRx394{&rx::kCuStw1, &rx::kADigital, &rx::kADigital1};
inline constexpr std::array<Sent, 3> kTx394{&tx::kCuZsw1, &tx::kEDigital, &tx::kEDigital1};

/// Ascending by number.
inline constexpr std::array kAll{
    Telegram{1, drive::kAxes, false, 0, kRx1, kTx1},
    Telegram{2, drive::kAxes, false, 0, kRx2, kTx2},
    Telegram{3, drive::kAxes, false, 0, kRx3, kTx3},
    Telegram{4, drive::kAxes, false, 0, kRx4, kTx4},
    Telegram{5, drive::kServo, false, 0, kRx5, kTx3},
    Telegram{6, drive::kServo, false, 0, kRx6, kTx4},
    Telegram{7, drive::kAxes, true, 0, kRx7, kTx7},
    Telegram{9, drive::kAxes, true, 0, kRx9, kTx9},
    Telegram{20, drive::kVector, false, 2, kRx20, kTx20},
    Telegram{102, drive::kServo, false, 1, kRx102, kTx102},
    Telegram{103, drive::kServo, false, 1, kRx103, kTx103},
    Telegram{105, drive::kServo, false, 1, kRx105, kTx102},
    Telegram{106, drive::kServo, false, 1, kRx106, kTx103},
    Telegram{110, drive::kAxes, true, 0, kRx110, kTx110},
    Telegram{111, drive::kAxes, true, 0, kRx111, kTx111},
    Telegram{116, drive::kServo, false, 1, kRx106, kTx116},
    Telegram{350, drive::kAxes, false, 0, kRx350, kTx350, false, true},
    Telegram{352, drive::kVector, false, 0, kRx352, kTx352},
    Telegram{353, drive::kAxes, false, 0, kRx1, kTx353, true, true},
    Telegram{354, drive::kAxes, false, 0, kRx352, kTx352, true, true},
    Telegram{390, drive::kControlUnit, false, 0, kRx390, kTx390},
    Telegram{391, drive::kControlUnit, false, 0, kRx391, kTx391},
    Telegram{394, drive::kControlUnit, false, 0, kRx394, kTx394},
};
// clang-format on

/// p0922 and p2079 of a drive object whose words are wired freely.
inline constexpr std::uint16_t kFreeWords = 999;

}  // namespace profidrive::telegrams
