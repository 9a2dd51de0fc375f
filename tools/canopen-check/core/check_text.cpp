#include <fmt/format.h>

#include "tools/canopen-check/core/check.hpp"

namespace conformance {

bool is_named(const Check& check, std::string_view word) noexcept {
  return name_of(check.group).word == word || check.id.starts_with(word);
}

std::string to_text(const Subject& subject) {
  if (!subject.index) return {};
  return subject.sub_index ? fmt::format("{:04X}h:{:02X}", *subject.index, *subject.sub_index)
                           : fmt::format("{:04X}h", *subject.index);
}

std::string_view word_of(Outcome outcome) noexcept {
  constexpr std::array<std::string_view, 5> kWords{"passed", "deviation", "failed", "skipped", "broken"};
  return kWords[static_cast<std::size_t>(outcome)];
}

}  // namespace conformance
