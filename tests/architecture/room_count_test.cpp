#include <array>
#include <filesystem>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/architecture/source_files.hpp"

namespace architecture {
namespace {

/// A room is a .cpp and .hpp of one name, or one of them alone.
constexpr std::size_t kMostRooms = 13;

constexpr std::array<std::string_view, 10> kFolders{"libcanopen", "text", "motor",  "drive", "device",
                                                    "eds",        "can",  "daemon", "tools", "bench"};

using Rooms = std::map<std::string, std::set<std::string>>;

/// The rooms of every folder in and below @p folder.
Rooms rooms_of(std::string_view folder) {
  Rooms rooms;
  for (const SourceFile& file : read_folder(SOURCE_FOLDER, folder)) {
    const std::filesystem::path path{file.path};
    rooms[path.parent_path().generic_string()].insert(path.stem().string());
  }
  return rooms;
}

TEST(Folders, HaveAboutADozenRooms) {
  for (const std::string_view top : kFolders) {
    const Rooms rooms = rooms_of(top);
    EXPECT_FALSE(rooms.empty()) << top;
    for (const auto& [folder, names] : rooms) EXPECT_LE(names.size(), kMostRooms) << folder;
  }
}

}  // namespace
}  // namespace architecture
