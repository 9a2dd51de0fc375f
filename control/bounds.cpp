#include "control/bounds.hpp"

#include <cstdint>
#include <vector>

namespace control {

std::string whole(double value) {
  return std::to_string(static_cast<std::int64_t>(value));
}

std::string alternatives_of(const Parameter& parameter, std::string_view quote) {
  std::vector<std::string> items;
  for (const std::string_view choice : parameter.choices)
    items.push_back(std::string{quote}.append(choice).append(quote));
  for (const Range& range : parameter.terminals)
    items.push_back(range.low < range.high ? whole(range.low) + " to " + whole(range.high) : whole(range.low));
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " or " : ", ") + items[i];
  return text;
}

}  // namespace control
