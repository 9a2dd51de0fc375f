#include "cli/scdoc_text.hpp"

namespace cli {

std::string scdoc_text(std::string_view text) {
  constexpr std::string_view kMarks = "\\_*[]|#+<>;.-~^";
  std::string result;
  for (const char c : text) {
    if (kMarks.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

}  // namespace cli
