#include "can/hub/faults/side.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "can/userbus/interface_name.hpp"

namespace hub::faults {

namespace {

constexpr auto kKinds = std::to_array<std::string_view>({"raw", "bcm", "port", "socketcand"});

std::vector<std::string> split(std::string_view words) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t comma = words.find(',');
    parts.emplace_back(words.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    words.remove_prefix(comma + 1);
  }
}

std::optional<std::int32_t> process_of(std::string_view word) noexcept {
  std::int32_t process = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), process);
  const bool is_right = error == std::errc{} && end == word.data() + word.size() && process > 0;
  return is_right ? std::optional{process} : std::nullopt;
}

bool is_interface(std::string_view word) noexcept {
  return userbus::is_can_name(word.data(), word.size());
}

bool can_be_a_name(std::string_view word) noexcept {
  return std::ranges::count(kKinds, word) != 0 || word.find("://") != std::string_view::npos ||
         word.starts_with("unix:");
}

}  // namespace

Side::Side(std::string_view words, Interfaces& interfaces) {
  for (const std::string& word : split(words)) {
    if (const auto process = process_of(word)) processes_.push_back(*process);
    if (is_interface(word)) interfaces_.push_back(interfaces.index_of(word));
    names_.push_back(word.substr(0, Identity{}.name.size() - 1));  // as much as is shown of one
  }
}

std::optional<std::string> Side::find_wrong(std::string_view words) {
  for (std::string& word : split(words))
    if (!process_of(word) && !is_interface(word) && !can_be_a_name(word)) return std::move(word);
  return std::nullopt;
}

bool Side::has(const Identity& who) const noexcept {
  const auto is = [](auto value) { return [value](const auto& other) { return other == value; }; };
  return std::ranges::any_of(processes_, is(who.process)) ||
         (who.interface_index > 0 && std::ranges::any_of(interfaces_, is(who.interface_index))) ||
         std::ranges::any_of(names_, is(std::string_view{who.name.data()}));
}

}  // namespace hub::faults
