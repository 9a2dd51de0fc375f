#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "tests/fuzz/check.hpp"
#include "tests/fuzz/dialogue.hpp"
#include "tests/fuzz/worlds.hpp"

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

Bytes input_in(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  const std::string content{std::istreambuf_iterator<char>{stream}, {}};
  if (file.extension() == ".txt") return fuzz::bytes_of_dialogue(content);
  return {content.begin(), content.end()};
}

/// Plays an input on stations that have played others before, and once more on new ones.
void replay(fuzz::Worlds& used, const Bytes& input) {
  const std::uint64_t first = used.play(input);
  fuzz::require(used.play(input) == first, "a reset leaves nothing of the run before it");
  fuzz::Worlds fresh;
  fuzz::require(fresh.play(input) == first, "a node after a reset is like a new one");
}

std::vector<fs::path> files_in(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator{path})
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

void write(const fs::path& file, const Bytes& input) {
  std::ofstream{file, std::ios::binary} << std::string{input.begin(), input.end()};
}

}  // namespace

/// node_replay [--trace | --write FOLDER] PATH...: plays the inputs in files and folders, those of the fuzzer as
/// they are, dialogues (.txt) translated. --trace prints all frames, --write keeps the inputs of the dialogues in
/// FOLDER.
int main(int count, char** arguments) {
  std::span words{arguments + 1, static_cast<std::size_t>(count - 1)};
  fs::path folder;
  fuzz::Worlds used;
  if (!words.empty() && std::string_view{words[0]} == "--trace") {
    used.trace();
    words = words.subspan(1);
  } else if (words.size() > 1 && std::string_view{words[0]} == "--write") {
    folder = words[1];
    words = words.subspan(2);
  }
  std::size_t played = 0;
  for (const char* const path : words) {
    for (const fs::path& file : files_in(path)) {
      std::cout << file.filename().string() << std::endl;  // the last line names the input that failed
      const Bytes input = input_in(file);
      replay(used, input);
      if (!folder.empty()) write(folder / file.stem(), input);
      ++played;
    }
  }
  std::cout << played << " inputs replayed\n";
  return played != 0 ? 0 : 1;
}
