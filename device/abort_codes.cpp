#include "device/abort_codes.hpp"

#include <algorithm>
#include <array>

namespace device {
namespace {

using canopen::AbortCode;
using drive::Refusal;

struct Row {
  Refusal reason;
  AbortCode code;
};
/// Of several reasons for a code the first one stands for it.
constexpr std::array kRows{
    Row{Refusal::NoParameter, AbortCode::NoObject},      Row{Refusal::NoDriveObject, AbortCode::NoObject},
    Row{Refusal::ReadOnly, AbortCode::ReadOnly},         Row{Refusal::NoIndex, AbortCode::NoSubIndex},
    Row{Refusal::NotIndexed, AbortCode::NoSubIndex},     Row{Refusal::WrongType, AbortCode::LengthMismatch},
    Row{Refusal::IllegalValue, AbortCode::InvalidValue}, Row{Refusal::OutOfRange, AbortCode::InvalidValue},
    Row{Refusal::OnlyZero, AbortCode::InvalidValue},     Row{Refusal::IllegalSource, AbortCode::InvalidValue},
    Row{Refusal::BelowMinimum, AbortCode::ValueTooLow},  Row{Refusal::AboveMaximum, AbortCode::ValueTooHigh},
};

}  // namespace

AbortCode abort_code(Refusal reason) noexcept {
  const auto* const row = std::ranges::find(kRows, reason, &Row::reason);
  return row != kRows.end() ? row->code : AbortCode::DeviceState;
}

Refusal refusal(AbortCode code) noexcept {
  const auto* const row = std::ranges::find(kRows, code, &Row::code);
  return row != kRows.end() ? row->reason : Refusal::NotNow;
}

}  // namespace device
