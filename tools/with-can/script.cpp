#include "tools/with-can/script.hpp"

#include <array>
#include <fstream>

namespace with_can {

namespace {

constexpr std::size_t kLongestLine = 255;  // what the kernel reads of it (bytes)
constexpr std::string_view kBlanks = " \t";

/// Takes the first word off @p text; empty if there is none.
std::string_view take_word(std::string_view& text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return text = {};
  text.remove_prefix(begin);
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  return word;
}

/// The program that env(1) runs, which is behind its options and its assignments.
std::string_view program_of_env(std::string_view words) {
  for (std::string_view word = take_word(words); !word.empty(); word = take_word(words)) {
    if (word == "-u" || word == "-C") {
      take_word(words);
      continue;
    }
    constexpr std::string_view kSplit = "-S";
    if (word.starts_with(kSplit) && word.size() > kSplit.size()) word.remove_prefix(kSplit.size());
    if (!word.starts_with('-') && word.find('=') == std::string_view::npos) return word;
  }
  return {};
}

}  // namespace

std::string interpreter_of_line(std::string_view first_line) {
  constexpr std::string_view kMark = "#!";
  if (!first_line.starts_with(kMark)) return {};
  std::string_view words = first_line.substr(kMark.size(), first_line.find('\n') - kMark.size());
  const std::string_view interpreter = take_word(words);
  if (std::filesystem::path{interpreter}.filename() != "env") return std::string{interpreter};
  const std::string_view program = program_of_env(words);
  return std::string{program.empty() ? interpreter : program};
}

std::optional<std::string> interpreter_of_script(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  if (!file) return std::nullopt;
  std::array<char, kLongestLine> line{};
  file.read(line.data(), line.size());
  const std::string_view text{line.data(), static_cast<std::size_t>(file.gcount())};
  return interpreter_of_line(text.substr(0, text.find('\n')));
}

}  // namespace with_can
