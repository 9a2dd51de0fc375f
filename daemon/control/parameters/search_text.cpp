#include "daemon/control/parameters/search_text.hpp"

#include <algorithm>

#include "drive/catalogue/effect_text.hpp"

namespace axisd {
namespace {

constexpr char lower(char letter) noexcept {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

std::string lowered(std::string_view text) {
  std::string result{text};
  std::ranges::transform(result, result.begin(), lower);
  return result;
}

bool is_digit(char letter) noexcept {
  return letter >= '0' && letter <= '9';
}

bool is_number(std::string_view word) noexcept {
  if (word.starts_with('p') || word.starts_with('r')) word.remove_prefix(1);
  return !word.empty() && std::ranges::all_of(word, is_digit);
}

}  // namespace

SearchText::SearchText(std::string_view text) {
  const std::string all = lowered(text);
  std::size_t begin = 0;
  while ((begin = all.find_first_not_of(" \t", begin)) != std::string::npos) {
    const std::size_t end = std::min(all.find_first_of(" \t", begin), all.size());
    words_.push_back(all.substr(begin, end - begin));
    begin = end;
  }
  if (words_.size() == 1 && is_number(words_.front())) number_ = words_.front();
}

bool SearchText::finds(const drive::ParameterRow& row) const {
  const std::string name = drive::parameter_text(row);
  if (!number_.empty()) {
    const bool has_letter = !is_digit(number_.front());
    return has_letter ? name.starts_with(number_)
                      : name.substr(1).starts_with(number_) || std::to_string(row.number).starts_with(number_);
  }
  const std::string told = lowered(row.name);
  const auto is_in_name = [&](const std::string& word) { return told.find(word) != std::string::npos; };
  if (std::ranges::all_of(words_, is_in_name)) return true;
  const std::string effect = lowered(drive::effect_text(row));
  return std::ranges::all_of(
      words_, [&](const std::string& word) { return is_in_name(word) || effect.find(word) != std::string::npos; });
}

}  // namespace axisd
