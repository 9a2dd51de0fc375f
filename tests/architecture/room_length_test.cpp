#include <algorithm>

#include <gtest/gtest.h>

#include "tests/architecture/source_files.hpp"

namespace architecture {
namespace {

constexpr std::size_t kLongest = 300;  // lines

/// A line for every file that is too long.
std::string too_long(std::string_view folder) {
  std::string report;
  for (const SourceFile& file : read_folder(SOURCE_FOLDER, folder))
    if (file.lines.size() > kLongest) report += file.path + ": " + std::to_string(file.lines.size()) + " lines\n";
  return report;
}

TEST(Rooms, HaveAtMost300Lines) {
  for (const std::string& folder : source_folders(SOURCE_FOLDER)) EXPECT_EQ(too_long(folder), "");
}

TEST(Rooms, AreFoundAtAll) {
  const auto folders = source_folders(SOURCE_FOLDER);

  for (const std::string_view known : {"libcanopen", "drive", "daemon", "tests"})
    EXPECT_EQ(std::ranges::count(folders, known), 1) << known;
}

}  // namespace
}  // namespace architecture
