#include "tests/architecture/source_files.hpp"

#include <algorithm>
#include <array>
#include <fstream>

namespace architecture {
namespace {

constexpr std::array<std::string_view, 4> kExtensions{".cpp", ".hpp", ".c", ".h"};

std::vector<std::string> read_lines(const std::filesystem::path& path) {
  std::vector<std::string> lines;
  std::ifstream file{path};
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

}  // namespace

std::vector<SourceFile> read_folder(const std::filesystem::path& root, std::string_view folder) {
  std::vector<SourceFile> files;
  if (!std::filesystem::is_directory(root / folder)) return files;
  for (std::filesystem::recursive_directory_iterator at{root / folder}, end; at != end; ++at) {
    const std::filesystem::directory_entry& entry = *at;
    if (entry.path().filename() == "node_modules") at.disable_recursion_pending();
    const bool source = std::ranges::count(kExtensions, entry.path().extension().string()) == 1;
    if (!entry.is_regular_file() || !source) continue;
    files.push_back({entry.path().lexically_relative(root).generic_string(), read_lines(entry.path())});
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<std::string> source_folders(const std::filesystem::path& root) {
  std::vector<std::string> folders;
  for (const auto& entry : std::filesystem::directory_iterator{root}) {
    const std::string name = entry.path().filename().string();
    if (std::filesystem::exists(entry.path() / "CMakeLists.txt") && !read_folder(root, name).empty())
      folders.push_back(name);
  }
  std::ranges::sort(folders);
  return folders;
}

}  // namespace architecture
