#include "drive/parameter/error.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "drive/parameter/row.hpp"

namespace drive {
namespace {

struct RefusalRow {
  Refusal reason;
  std::string_view text;
};
constexpr std::array kTexts{
    RefusalRow{Refusal::NoParameter, "no such parameter"},
    RefusalRow{Refusal::ReadOnly, "read only"},
    RefusalRow{Refusal::OutOfRange, "outside the limits"},
    RefusalRow{Refusal::NoIndex, "no such index"},
    RefusalRow{Refusal::NotIndexed, "has no indices"},
    RefusalRow{Refusal::WrongType, "not a value of its type"},
    RefusalRow{Refusal::OnlyZero, "can only be set to 0"},
    RefusalRow{Refusal::NotNow, "cannot be written in the present state of the unit"},
    RefusalRow{Refusal::IllegalValue, "not one of its values"},
    RefusalRow{Refusal::NoDriveObject, "no such drive object"},
    RefusalRow{Refusal::Deactivated, "set by the address switch, cannot be written"},
    RefusalRow{Refusal::PulsesEnabled, "cannot be written while the pulses are enabled"},
    RefusalRow{Refusal::OnlyInEncoderCommissioning, "can only be written with p0010 = 4"},
    RefusalRow{Refusal::OnlyInMotorCommissioning, "can only be written with p0010 = 3 or 1"},
    RefusalRow{Refusal::OnlyInQuickCommissioning, "can only be written with p0010 = 1"},
    RefusalRow{Refusal::OnlyInParameterReset, "can only be written with p0010 = 30"},
    RefusalRow{Refusal::OnlyInDriveConfiguration, "can only be written with p0009 = 3"},
    RefusalRow{Refusal::OnlyInDeviceReset, "can only be written with p0009 = 30"},
    RefusalRow{Refusal::OnlyInDeviceCommissioning, "can only be written with p0009 not 0"},
    RefusalRow{Refusal::IllegalSource, "not a BICO source that it can be connected to"},
    RefusalRow{Refusal::BelowMinimum, "below the minimum"},
    RefusalRow{Refusal::AboveMaximum, "above the maximum"},
};
static_assert(std::is_sorted(kTexts.begin(), kTexts.end(),
                             [](const RefusalRow& a, const RefusalRow& b) { return a.reason < b.reason; }));

/// " of 999999 s" behind the text of a broken limit.
std::string limit(const ParameterError& error) {
  const Range limits = limits_of(*error.row);
  const double value = error.reason == Refusal::BelowMinimum ? limits.minimum : limits.maximum;
  const std::string_view unit = row_of(error.row->unit).text;
  return fmt::format(" of {}{}{}", value, unit.empty() ? "" : " ", unit);
}

}  // namespace

std::string_view text_of(Refusal reason) noexcept {
  const auto row =
      std::find_if(kTexts.begin(), kTexts.end(), [=](const RefusalRow& r) { return r.reason == reason; });
  return row != kTexts.end() ? row->text : "refused";
}

std::string message(const ParameterError& error) {
  if (error.row == nullptr) return fmt::format("p{:04}: {}", error.number, text_of(error.reason));
  const ParameterRow& row = *error.row;
  const std::string name = parameter_text(row);
  const Range limits = limits_of(row);
  if (error.reason == Refusal::WrongType && row.type != DataType::F32)
    return fmt::format("{}: expected an integer {}..{}", name, limits.minimum, limits.maximum);
  const bool broken = error.reason == Refusal::BelowMinimum || error.reason == Refusal::AboveMaximum;
  return fmt::format("{}: {}{}", name, text_of(error.reason), broken ? limit(error) : "");
}

}  // namespace drive
