#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>

#include "injection/language/fault.hpp"

namespace injection {

/// A key that says when a fault happens.
struct WhenRow {
  std::string_view key;
  std::string_view summary;
  std::string (*expected)();
  /// Takes @p value over; false if it is not what is expected.
  bool (*read)(const nlohmann::json& value, When& when);
  /// What @p when has; null: nothing that differs from its absence.
  nlohmann::json (*write)(const When& when);
};

/// All of them, in the order in which they are printed.
std::span<const WhenRow> when_rows() noexcept;

/// The whole number that @p value is or spells, in decimal or as 0x...; digits alone are hexadecimal if @p
/// hexadecimal.
std::optional<std::uint64_t> whole_number(const nlohmann::json& value, bool hexadecimal = false);

}  // namespace injection
