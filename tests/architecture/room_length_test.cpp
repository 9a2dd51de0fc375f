#include <array>

#include <gtest/gtest.h>

#include "tests/architecture/source_files.hpp"

namespace architecture {
namespace {

constexpr std::size_t kLongest = 300;  // lines

constexpr std::array<std::string_view, 15> kFolders{"os",     "control", "libcanopen", "motor", "drive",
                                                    "device", "eds",     "userbus",    "bus",   "hub",
                                                    "daemon", "tools",   "preload",    "tests", "bench"};

/// A line for every file that is too long.
std::string too_long(std::string_view folder) {
  std::string report;
  for (const SourceFile& file : read_folder(SOURCE_FOLDER, folder))
    if (file.lines.size() > kLongest) report += file.path + ": " + std::to_string(file.lines.size()) + " lines\n";
  return report;
}

TEST(Rooms, HaveAtMost300Lines) {
  for (const std::string_view folder : kFolders) EXPECT_EQ(too_long(folder), "");
}

TEST(Rooms, AreFoundAtAll) {
  EXPECT_FALSE(read_folder(SOURCE_FOLDER, "libcanopen").empty());
}

}  // namespace
}  // namespace architecture
