#include "tools/axisctl/print/table.hpp"

#include <algorithm>
#include <ostream>
#include <string_view>

namespace axisctl {
namespace {

constexpr std::size_t kGap = 2;
constexpr unsigned kContinuationMask = 0xC0, kContinuation = 0x80;

/// Characters of @p text, which is UTF-8.
std::size_t width(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & kContinuationMask) != kContinuation; }));
}

}  // namespace

void Table::print(std::ostream& out, bool with_heads, std::size_t indent) const {
  std::vector<std::size_t> widths(lines_.front().size());
  for (std::size_t line = with_heads ? 0 : 1; line < lines_.size(); ++line)
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width(lines_[line][i]));
  for (std::size_t line = with_heads ? 0 : 1; line < lines_.size(); ++line) {
    std::string text(indent, ' ');
    for (std::size_t i = 0; i < widths.size(); ++i)
      text += lines_[line][i] + std::string(widths[i] - width(lines_[line][i]) + kGap, ' ');
    text.erase(text.find_last_not_of(' ') + 1);
    out << text << '\n';
  }
}

}  // namespace axisctl
