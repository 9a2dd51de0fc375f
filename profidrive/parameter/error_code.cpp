#include "profidrive/parameter/error_code.hpp"

#include "drive/parameter/row.hpp"

namespace profidrive {
namespace {

using drive::RefusalReason;

/// REAL32 limits are compared as such; what is no number is within none.
bool is_within(const drive::ParameterRow& row, double value) noexcept {
  const drive::Range limits = drive::limits_of(row);
  const auto represented = [&](double number) {
    return row.type == drive::DataType::F32 ? static_cast<double>(static_cast<float>(number)) : number;
  };
  return value >= represented(limits.minimum) && value <= represented(limits.maximum);
}

}  // namespace

RefusalReason told_reason(const drive::ParameterError& error, std::optional<double> value) noexcept {
  const RefusalReason reason = error.reason.why;
  const bool is_limit = reason == RefusalReason::BelowMinimum || reason == RefusalReason::AboveMaximum;
  const bool is_of_row = is_limit && error.row != nullptr && (!value || !is_within(*error.row, *value));
  return is_of_row ? RefusalReason::OutOfRange : reason;
}

}  // namespace profidrive
