#include "drive/catalogue/effect_text.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "drive/base/function_modules.hpp"

namespace drive {
namespace {

/// What would make a parameter act that does nothing yet.
std::string until(const ParameterRow& row, std::string_view itself) {
  const function_module::Missing* const missing = function_module::missing_of(row.number);
  if (missing == nullptr) return std::string{itself};
  return fmt::format("the function module {} (p0108.{}), which is not simulated yet", missing->name,
                     std::countr_zero(missing->module));
}

/// Whether the effect of @p row says what acts on what is written.
bool acts(const ParameterRow& row) {
  return std::holds_alternative<Slot>(row.home) || std::holds_alternative<BitInput>(row.home) ||
         std::holds_alternative<ValueInput>(row.home) || std::holds_alternative<ImageInput>(row.home);
}

}  // namespace

std::string number_text(double value) {
  constexpr double kLarge = 16777216.0;
  const bool integer = !(std::abs(value - std::trunc(value)) > 0.0);
  if (integer && value >= kLarge && value <= 4294967295.0)
    return fmt::format("{:X}h", static_cast<std::uint32_t>(value));
  return fmt::format("{}", value);
}

std::string role_text(const ParameterRow& row) {
  if (const auto* const stored = std::get_if<Stored>(&row.home))
    return fmt::format("{}; would act with {}", is_bico_input(row.type) ? "wiring stored" : "stored only",
                       until(row, stored->until));
  if (std::holds_alternative<Agreed>(row.home)) return is_bico_input(row.type) ? "wiring stored" : "bus";
  if (std::holds_alternative<HostCommand>(row.home)) return "command";
  if (const auto* const fixed = std::get_if<Fixed>(&row.home))
    return fmt::format("fixed: {}; would change with {}", number_text(fixed->value), until(row, fixed->until));
  return row.is_writable() ? "" : "true value";
}

std::string effect_text(const ParameterRow& row) {
  const std::string means = role_text(row);
  if (acts(row)) return fmt::format("acts on {}", row.effect);
  const std::string_view between = means.empty() || row.effect.empty() ? "" : "; ";
  return fmt::format("{}{}{}", means, between, row.effect);
}

}  // namespace drive
