#include "device/objects/abort_codes.hpp"

#include <algorithm>
#include <array>

namespace device {
namespace {

using canopen::AbortCode;
using drive::Refusal;
using drive::RefusalReason;

struct Row {
  RefusalReason reason;
  AbortCode code;
};
/// Of several reasons for a code the first one stands for it.
constexpr std::array kRows{
    Row{RefusalReason::NoParameter, AbortCode::NoObject},
    Row{RefusalReason::NoDriveObject, AbortCode::NoObject},
    Row{RefusalReason::ReadOnly, AbortCode::ReadOnly},
    Row{RefusalReason::NoIndex, AbortCode::NoSubIndex},
    Row{RefusalReason::NotIndexed, AbortCode::NoSubIndex},
    Row{RefusalReason::WrongType, AbortCode::LengthMismatch},
    Row{RefusalReason::IllegalValue, AbortCode::InvalidValue},
    Row{RefusalReason::OutOfRange, AbortCode::InvalidValue},
    Row{RefusalReason::OnlyZero, AbortCode::InvalidValue},
    Row{RefusalReason::IllegalSource, AbortCode::InvalidValue},
    Row{RefusalReason::BelowMinimum, AbortCode::ValueTooLow},
    Row{RefusalReason::AboveMaximum, AbortCode::ValueTooHigh},
    Row{RefusalReason::BadFormat, AbortCode::LengthMismatch},
    Row{RefusalReason::CountMismatch, AbortCode::LengthMismatch},
    Row{RefusalReason::BadAddress, AbortCode::NoObject},
    Row{RefusalReason::AnswerTooLong, AbortCode::OutOfMemory},
    Row{RefusalReason::Failed, AbortCode::HardwareError},
};

}  // namespace

AbortCode abort_code(const Refusal& refusal) noexcept {
  if (refusal.host_code != 0) return AbortCode{refusal.host_code};
  const auto* const row = std::ranges::find(kRows, refusal.why, &Row::reason);
  return row != kRows.end() ? row->code : AbortCode::DeviceState;
}

std::optional<Refusal> refusal(const canopen::Result<void>& result) noexcept {
  if (result) return std::nullopt;
  const auto* const row = std::ranges::find(kRows, result.error(), &Row::code);
  const RefusalReason reason = row != kRows.end() ? row->reason : RefusalReason::NotNow;
  return Refusal{reason, static_cast<std::uint32_t>(result.error())};
}

canopen::Result<void> result(const std::optional<Refusal>& refusal) noexcept {
  return refusal ? canopen::refuse(abort_code(*refusal)) : canopen::Result<void>{};
}

}  // namespace device
