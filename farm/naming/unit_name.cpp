#include "farm/naming/unit_name.hpp"

#include <algorithm>

#include "control/socket_name.hpp"
#include "text/name.hpp"

namespace farm {
namespace {

/// BUS and NODE on both sides of the last @p between.
std::optional<UnitName> split(std::string_view text, char between) {
  const std::size_t at = text.rfind(between);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view bus = text.substr(0, at);
  const std::string_view node = text.substr(at + 1);
  if (!is_name(bus) || !control::is_station(node)) return std::nullopt;
  return UnitName{std::string{bus}, std::string{node}};
}

}  // namespace

bool is_name(std::string_view words) noexcept {
  return text::is_name(words);
}

std::optional<UnitName> parse_unit_name(std::string_view text) {
  return split(text, '/');
}

std::optional<UnitName> parse_unit_key(std::string_view key) {
  return split(key, '.');
}

std::optional<UnitName> unit_name_of_daemon(std::string_view label_and_station) {
  const std::size_t slash = label_and_station.rfind('/');
  if (slash == std::string_view::npos) return std::nullopt;
  return split(name_from(label_and_station.substr(0, slash)).append(label_and_station.substr(slash)), '/');
}

std::string name_from(std::string_view words) {
  std::string name{words.substr(0, text::kLongestName)};
  std::ranges::replace_if(
      name, [](char c) { return !text::is_of_name(c); }, '_');
  return name;
}

}  // namespace farm
