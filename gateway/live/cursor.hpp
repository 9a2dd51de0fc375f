#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gateway {

/// How far somebody has read in one feed.
struct FeedPosition {
  std::uint64_t feed = 0;  ///< its number, of which no other feed is, whatever gateway it was in
  std::uint64_t line = 0;  ///< number of the last line that was read; 0: none

  bool operator==(const FeedPosition&) const = default;
};

/// How far in all feeds of an answer. As text "16 hexadecimal digits.decimal number", with '_' between feeds: it
/// is in a URL as it stands.
using Cursor = std::vector<FeedPosition>;
/// Most feeds of an answer.
inline constexpr std::size_t kMostPositions = 2;

[[nodiscard]] std::string text_of(const Cursor& cursor);
/// The cursor in @p text; nothing if it is none.
[[nodiscard]] std::optional<Cursor> parse_cursor(std::string_view text);

}  // namespace gateway
