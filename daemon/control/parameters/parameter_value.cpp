#include "daemon/control/parameters/parameter_value.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "device/objects/abort_codes.hpp"
#include "drive/parameter/bico_text.hpp"
#include "libcanopen/od/abort_text.hpp"
#include "text/number.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using drive::RefusalReason;
using nlohmann::json;

/// The shortest number that stands for @p value.
double shortest(float value) noexcept {
  constexpr std::size_t kLongest = 32;
  std::array<char, kLongest> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return text::real({digits.data(), static_cast<std::size_t>(end - digits.data())}).value_or(0.0);
}

std::optional<double> with_base(std::string_view digits, int base) noexcept {
  const auto number = text::integer<std::uint32_t>(digits, base);
  return number ? std::optional{static_cast<double>(*number)} : std::nullopt;
}

std::optional<double> number_in(std::string_view text) noexcept {
  if (text.starts_with("0x") || text.starts_with("0X")) return with_base(text.substr(2), 16);
  if (text.starts_with("0b") || text.starts_with("0B")) return with_base(text.substr(2), 2);
  if (text.ends_with('h') || text.ends_with('H')) return with_base(text.substr(0, text.size() - 1), 16);
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto number = text::real(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<double> plain_number(const drive::DriveUnit& unit, const ParameterTarget& target,
                                   const json& value) {
  if (value.is_boolean()) return value.get<bool>() ? 1.0 : 0.0;
  if (value.is_number()) return value.get<double>();
  if (!value.is_string()) return std::nullopt;
  const auto& text = value.get_ref<const std::string&>();
  const drive::DataType type = target.row().type;
  if (drive::is_bico_input(type) && !target.bit)
    if (const auto source = drive::parse_bico(text, type, unit.first_axis())) return *source;
  return number_in(text);
}

std::string_view expected_value(const ParameterTarget& target) {
  if (target.bit) return "0 or 1";
  if (target.row().type == drive::DataType::BinectorInput) return "a source as r0722.3, r0899.2 of axis 2, 0 or 1";
  if (target.row().type == drive::DataType::ConnectorInput) return "a source as r0063, r8860[1] of axis 2, 0 or 1";
  return "a number, decimal or as 0x1F, 1Fh or 0b101";
}

/// Which error of the socket a reason is.
struct ReasonRow {
  RefusalReason reason;
  ErrorCode code;
};
constexpr std::array kReasons{
    ReasonRow{RefusalReason::NoParameter, ErrorCode::NotFound},
    ReasonRow{RefusalReason::NoIndex, ErrorCode::NotFound},
    ReasonRow{RefusalReason::NotIndexed, ErrorCode::NotFound},
    ReasonRow{RefusalReason::NoDriveObject, ErrorCode::NotFound},
    ReasonRow{RefusalReason::OutOfRange, ErrorCode::OutOfRange},
    ReasonRow{RefusalReason::WrongType, ErrorCode::OutOfRange},
    ReasonRow{RefusalReason::OnlyZero, ErrorCode::OutOfRange},
    ReasonRow{RefusalReason::IllegalValue, ErrorCode::OutOfRange},
    ReasonRow{RefusalReason::IllegalSource, ErrorCode::OutOfRange},
    ReasonRow{RefusalReason::BelowMinimum, ErrorCode::OutOfRange},
    ReasonRow{RefusalReason::AboveMaximum, ErrorCode::OutOfRange},
    ReasonRow{RefusalReason::NotNow, ErrorCode::Refused},
    ReasonRow{RefusalReason::Failed, ErrorCode::Refused},
};

/// The others depend on the state of the drive object, or never hold.
ErrorCode code_of(RefusalReason reason) noexcept {
  const auto* const row = std::ranges::find(kReasons, reason, &ReasonRow::reason);
  return row != kReasons.end() ? row->code : ErrorCode::ReadOnly;
}

}  // namespace

json value_json(const drive::ParameterRow& row, const drive::ParameterValue& value,
                const drive::DriveObject& object) {
  if (row.type == drive::DataType::F32) return shortest(std::bit_cast<float>(value.bits));
  if (!drive::is_bico_input(row.type)) return static_cast<std::int64_t>(drive::decode(value));
  if (value.bits <= drive::kHighestConstant) return std::to_string(value.bits);
  return drive::bico_text(drive::unpack(value.bits), row.type, object.number());
}

Taken<double> number_of(const drive::DriveUnit& unit, const ParameterTarget& target, const json& value) {
  const auto refused = [&] { return tl::unexpected{unexpected_value("value", expected_value(target), &value)}; };
  const auto number = plain_number(unit, target, value);
  if (!number) return refused();
  if (!target.bit) return *number;
  const bool high = *number > 0.0;
  if (*number < 0.0 || *number > (high ? 1.0 : 0.0)) return refused();
  const auto present = unit.read(target.object->number(), target.row().number, target.index);
  if (!present) return tl::unexpected{refusal_of(present.error(), target, false)};
  const std::uint32_t bit = std::uint32_t{1} << *target.bit;
  return drive::decode({present->type, high ? present->bits | bit : present->bits & ~bit});
}

json limits_json(const drive::ParameterRow& row) {
  if (drive::is_bico_input(row.type)) return nullptr;
  if (row.type == drive::DataType::F32 && row.range == drive::kWhole) return nullptr;
  const drive::Range limits = drive::limits_of(row);
  return {{"minimum", limits.minimum}, {"maximum", limits.maximum}, {"unit", drive::row_of(row.unit).text}};
}

control::Error refusal_of(const drive::ParameterError& error, const ParameterTarget& target, bool is_saving) {
  if (is_saving)
    return {ErrorCode::Busy, fmt::format("{}: parameters are being saved: try again", parameter_text(target)), {}};
  const drive::ParameterRow& row = target.row();
  const canopen::AbortCode abort = device::abort_code(error.reason);
  json details{{"reason", static_cast<int>(error.reason.why)},
               {"abort_code", static_cast<std::uint32_t>(abort)},
               {"abort_text", canopen::text_of(abort)}};
  const ErrorCode code = code_of(error.reason.why);
  if (code == ErrorCode::OutOfRange)
    if (json limits = limits_json(row); !limits.is_null()) details["limits"] = std::move(limits);
  if (code == ErrorCode::ReadOnly && row.is_writable()) details["when"] = drive::row_of(row.when).text;
  return {code, drive::message({error.reason, error.number, &row}), std::move(details)};
}

}  // namespace axisd
