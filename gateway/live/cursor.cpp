#include "gateway/live/cursor.hpp"

#include <fmt/format.h>

#include "text/number.hpp"

namespace gateway {
namespace {

constexpr std::size_t kDigits = 16;  // of the number of a feed
constexpr int kHexadecimal = 16;

std::optional<FeedPosition> parse_position(std::string_view text) {
  if (text.size() <= kDigits || text[kDigits] != '.') return std::nullopt;
  const auto feed = text::integer<std::uint64_t>(text.substr(0, kDigits), kHexadecimal);
  const auto line = text::integer<std::uint64_t>(text.substr(kDigits + 1));
  return feed && line ? std::optional{FeedPosition{*feed, *line}} : std::nullopt;
}

}  // namespace

std::string text_of(const Cursor& cursor) {
  std::string text;
  for (const FeedPosition& position : cursor)
    text += fmt::format("{}{:016x}.{}", text.empty() ? "" : "_", position.feed, position.line);
  return text;
}

std::optional<Cursor> parse_cursor(std::string_view text) {
  Cursor cursor;
  while (true) {
    const std::size_t end = text.find('_');
    const auto position = parse_position(text.substr(0, end));
    if (!position || cursor.size() == kMostPositions) return std::nullopt;
    cursor.push_back(*position);
    if (end == std::string_view::npos) return cursor;
    text.remove_prefix(end + 1);
  }
}

}  // namespace gateway
