#include "injection/language/event.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "text/number.hpp"

namespace injection {
namespace {

constexpr int kHexadecimal = 16;
constexpr std::uint32_t kHighestIdentifier = 0x1FFFFFFF;

}  // namespace

std::optional<Event> parse_event(std::string_view text) noexcept {
  const std::size_t blank = text.find(' ');
  const auto* const name = std::ranges::find(kEventNames, text.substr(0, blank));
  if (name == kEventNames.end()) return std::nullopt;
  Event event{.kind = static_cast<EventKind>(name - kEventNames.begin())};
  if (blank == std::string_view::npos) return event;
  std::string_view digits = text.substr(blank + 1);
  if (digits.starts_with("0x")) digits.remove_prefix(2);
  event.identifier = text::integer<std::uint32_t>(digits, kHexadecimal);
  const bool is_right =
      event.kind == EventKind::Frame && event.identifier && *event.identifier <= kHighestIdentifier;
  return is_right ? std::optional{event} : std::nullopt;
}

std::string text_of(const Event& event) {
  const std::string_view name = kEventNames[static_cast<std::size_t>(event.kind)];
  return event.identifier ? fmt::format("{} {:03X}", name, *event.identifier) : std::string{name};
}

std::optional<Milestone> parse_milestone(std::string_view text) noexcept {
  const auto count = text::take_integer<std::uint32_t>(text);
  if (!count || *count == 0 || !text.starts_with(' ')) return std::nullopt;
  const auto event = parse_event(text.substr(1));
  return event ? std::optional{Milestone{*count, *event}} : std::nullopt;
}

std::string text_of(const Milestone& milestone) {
  return fmt::format("{} {}", milestone.count, text_of(milestone.event));
}

std::string event_rule() {
  return fmt::format("{}, frame with an identifier (\"frame 185\") too", fmt::join(kEventNames, ", "));
}

}  // namespace injection
