#include "drive/parameter/error.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "drive/parameter/row.hpp"

namespace drive {
namespace {

struct ReasonRow {
  RefusalReason reason;
  std::string_view text;
};
constexpr std::array kTexts{
    ReasonRow{RefusalReason::NoParameter, "no such parameter"},
    ReasonRow{RefusalReason::ReadOnly, "read only"},
    ReasonRow{RefusalReason::OutOfRange, "outside the limits"},
    ReasonRow{RefusalReason::NoIndex, "no such index"},
    ReasonRow{RefusalReason::NotIndexed, "has no indices"},
    ReasonRow{RefusalReason::WrongType, "not a value of its type"},
    ReasonRow{RefusalReason::OnlyZero, "can only be set to 0"},
    ReasonRow{RefusalReason::DescriptionFixed, "its description cannot be written"},
    ReasonRow{RefusalReason::NoDescription, "no such element of a description"},
    ReasonRow{RefusalReason::NoAuthority, "p0927 does not let this interface write"},
    ReasonRow{RefusalReason::NoText, "has no texts"},
    ReasonRow{RefusalReason::NotNow, "cannot be written in the present state of the unit"},
    ReasonRow{RefusalReason::Failed, "could not be carried out"},
    ReasonRow{RefusalReason::IllegalValue, "not one of its values"},
    ReasonRow{RefusalReason::AnswerTooLong, "too long for the rest of the answer"},
    ReasonRow{RefusalReason::BadAddress, "not an address of a parameter"},
    ReasonRow{RefusalReason::BadFormat, "unknown format"},
    ReasonRow{RefusalReason::CountMismatch, "another number of values than of elements"},
    ReasonRow{RefusalReason::NoDriveObject, "no such drive object"},
    ReasonRow{RefusalReason::UnknownService, "unknown service"},
    ReasonRow{RefusalReason::Deactivated, "set by the address switch, cannot be written"},
    ReasonRow{RefusalReason::ChannelTooNarrow, "longer than the channel is wide"},
    ReasonRow{RefusalReason::UnknownRequest, "unknown request"},
    ReasonRow{RefusalReason::PulsesEnabled, "cannot be written while the pulses are enabled"},
    ReasonRow{RefusalReason::OnlyInEncoderCommissioning, "can only be written with p0010 = 4"},
    ReasonRow{RefusalReason::OnlyInMotorCommissioning, "can only be written with p0010 = 3 or 1"},
    ReasonRow{RefusalReason::OnlyInQuickCommissioning, "can only be written with p0010 = 1"},
    ReasonRow{RefusalReason::OnlyInParameterReset, "can only be written with p0010 = 30"},
    ReasonRow{RefusalReason::OnlyInDriveConfiguration, "can only be written with p0009 = 3"},
    ReasonRow{RefusalReason::OnlyInDeviceReset, "can only be written with p0009 = 30"},
    ReasonRow{RefusalReason::OnlyInDeviceCommissioning, "can only be written with p0009 not 0"},
    ReasonRow{RefusalReason::ControlPriority, "another master has control"},
    ReasonRow{RefusalReason::IllegalSource, "not a BICO source that it can be connected to"},
    ReasonRow{RefusalReason::Locked, "locked by the telegram that p0922 or p2079 selects"},
    ReasonRow{RefusalReason::BelowMinimum, "below the minimum"},
    ReasonRow{RefusalReason::AboveMaximum, "above the maximum"},
};
static_assert(std::is_sorted(kTexts.begin(), kTexts.end(),
                             [](const ReasonRow& a, const ReasonRow& b) { return a.reason < b.reason; }));

/// " of 999999 s" behind the text of a broken limit.
std::string limit(const ParameterError& error) {
  const Range limits = limits_of(*error.row);
  const double value = error.reason == RefusalReason::BelowMinimum ? limits.minimum : limits.maximum;
  const std::string_view unit = row_of(error.row->unit).text;
  return fmt::format(" of {}{}{}", value, unit.empty() ? "" : " ", unit);
}

}  // namespace

std::string_view text_of(RefusalReason reason) noexcept {
  const auto row =
      std::find_if(kTexts.begin(), kTexts.end(), [=](const ReasonRow& r) { return r.reason == reason; });
  return row != kTexts.end() ? row->text : "refused";
}

std::string message(const ParameterError& error) {
  if (error.row == nullptr) return fmt::format("p{:04}: {}", error.number, text_of(error.reason.why));
  const ParameterRow& row = *error.row;
  const std::string name = parameter_text(row);
  const Range limits = limits_of(row);
  if (error.reason == RefusalReason::WrongType && row.type != DataType::F32)
    return fmt::format("{}: expected an integer {}..{}", name, limits.minimum, limits.maximum);
  const bool broken = error.reason == RefusalReason::BelowMinimum || error.reason == RefusalReason::AboveMaximum;
  return fmt::format("{}: {}{}", name, text_of(error.reason.why), broken ? limit(error) : "");
}

}  // namespace drive
