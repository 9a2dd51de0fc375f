#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace axisd {

/// A value of a log line that the journal keeps as a field of its own, too: `journalctl AXIS=1`.
struct LogField {
  std::string_view name;  ///< in capitals, as systemd.journal-fields(7) has them; a literal
  std::string text;
};

/// Axis @p number (1..), or 0 for the control unit.
inline LogField axis_field(std::size_t number) {
  return {"AXIS", std::to_string(number)};
}
/// The fault or alarm called @p name: "F07860", "A08511".
inline LogField fault_field(std::string name) {
  return {"FAULT", std::move(name)};
}
/// The identifier of a frame; "285".
inline LogField cob_id_field(std::uint32_t identifier) {
  return {"COB_ID", fmt::format("{:03X}", identifier)};
}

/// The fields among the arguments of a line; the others are nullptr.
template <class... Arguments>
std::array<const LogField*, sizeof...(Arguments)> fields_of(const Arguments&... arguments) noexcept {
  [[maybe_unused]] const auto field = [](const auto& argument) -> const LogField* {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(argument)>, LogField>) return &argument;
    return nullptr;
  };
  return {field(arguments)...};
}

}  // namespace axisd

/// In the line itself a field is its value.
template <>
struct fmt::formatter<axisd::LogField> : fmt::formatter<std::string_view> {
  template <class Context>
  auto format(const axisd::LogField& field, Context& context) const {
    return fmt::formatter<std::string_view>::format(field.text, context);
  }
};
