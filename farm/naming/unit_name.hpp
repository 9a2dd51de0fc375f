#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace farm {

/// A unit of a farm: "line1/5" for people and on control sockets, "line1.5" in subjects and as a key.
struct UnitName {
  std::string bus;   ///< 1 to 32 letters, digits, '-' and '_'
  std::string node;  ///< its station: "1" to "127", or what control::is_station() takes else

  [[nodiscard]] std::string text() const { return bus + '/' + node; }
  [[nodiscard]] std::string key() const { return bus + '.' + node; }

  friend auto operator<=>(const UnitName&, const UnitName&) = default;
};

/// Whether @p words can be the name of a farm, of a bus or of a host: 1 to 32 letters, digits, '-' and '_'.
[[nodiscard]] bool is_name(std::string_view words) noexcept;
/// A name made of @p words, such as that of a machine: what a name may not have becomes '_', and what is too long
/// is cut. Empty only if @p words is.
[[nodiscard]] std::string name_from(std::string_view words);
/// Reads "BUS/NODE".
[[nodiscard]] std::optional<UnitName> parse_unit_name(std::string_view text);
/// Reads "BUS.NODE".
[[nodiscard]] std::optional<UnitName> parse_unit_key(std::string_view key);
/// A unit of a daemon that was not started for a farm: the label of its bus (bus::label()) as name_from() makes a
/// name of it.
[[nodiscard]] std::optional<UnitName> unit_name_of_daemon(std::string_view label_and_station);

}  // namespace farm
