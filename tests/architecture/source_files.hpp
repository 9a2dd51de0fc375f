#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace architecture {

/// A source file and its lines; `path` is relative to the root, with slashes.
struct SourceFile {
  std::string path;
  std::vector<std::string> lines;
};

/// Every .cpp, .hpp, .c and .h file below @p root / @p folder, in order of path; none where the folder is missing.
std::vector<SourceFile> read_folder(const std::filesystem::path& root, std::string_view folder);

/// The folders that the build takes part of @p root from: those with a CMakeLists.txt and a source file.
std::vector<std::string> source_folders(const std::filesystem::path& root);

}  // namespace architecture
