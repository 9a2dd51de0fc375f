#include "daemon/state_files.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

using Bytes = std::vector<std::byte>;

Bytes bytes(std::size_t count, int value) {
  return Bytes(count, static_cast<std::byte>(value));
}

/// A file in a folder of its own.
struct StateFileTest : testing::Test {
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator{folder.path()})
      found.push_back(entry.path().filename().string());
    std::ranges::sort(found);
    return found;
  }
  void put(const std::string& name, const std::string& text) const { std::ofstream{folder.path(name)} << text; }
  /// What @p act writes to the log.
  template <class Act>
  std::string log_of(const Act& act) const {
    testing::internal::CaptureStderr();
    act();
    return testing::internal::GetCapturedStderr();
  }

  fakes::TemporaryDirectory folder;
  Log log{LogLevel::Info};
  StateFile file{folder.path(), "state.bin", log};
  std::string path = folder.path("state.bin");
};

TEST_F(StateFileTest, IsNotThereAtFirst) {
  EXPECT_EQ(log_of([&] { EXPECT_EQ(file.read(), std::nullopt); }), "");
}

TEST_F(StateFileTest, GivesBackWhatWasWrittenLast) {
  for (const Durability durability : {Durability::OnDisk, Durability::InTheCache}) {
    ASSERT_TRUE(file.write(bytes(200000, 1), durability));
    ASSERT_TRUE(file.write(bytes(100, 2), durability));

    EXPECT_EQ(file.read(), bytes(100, 2));
  }
  EXPECT_EQ(names(), std::vector<std::string>{"state.bin"});
}

TEST_F(StateFileTest, BelongsToItsUserAlone) {
  ASSERT_TRUE(file.write(bytes(1, 1), Durability::OnDisk));

  struct stat status {};
  ASSERT_EQ(stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(StateFileTest, ReplacesWhatAnInterruptedWriteLeftBehind) {
  ASSERT_TRUE(file.write(bytes(10, 1), Durability::OnDisk));
  put("state.bin.new", "half of a longer content than the next one");

  EXPECT_EQ(file.read(), bytes(10, 1));
  ASSERT_TRUE(file.write(bytes(10, 2), Durability::OnDisk));

  EXPECT_EQ(file.read(), bytes(10, 2));
  EXPECT_EQ(names(), std::vector<std::string>{"state.bin"});
}

TEST_F(StateFileTest, IsWholeForAReaderAtEveryMoment) {
  constexpr std::size_t kSize = 50000;
  ASSERT_TRUE(file.write(bytes(kSize, 0), Durability::InTheCache));
  std::jthread writer{[this] {
    for (int i = 1; i <= 200; ++i) EXPECT_TRUE(file.write(bytes(kSize, i), Durability::InTheCache));
  }};

  for (int i = 0; i < 200; ++i) {
    const auto content = file.read();
    ASSERT_TRUE(content);
    ASSERT_EQ(content->size(), kSize);
    EXPECT_EQ(content->front(), content->back());
  }
}

TEST_F(StateFileTest, SetsAsideWhatCannotBeUsedAndLosesNothing) {
  for (const char* const text : {"one", "two", "three"}) {
    put("state.bin", text);
    file.set_aside("a reason");
  }

  EXPECT_EQ(file.read(), std::nullopt);
  EXPECT_EQ(names(), (std::vector<std::string>{"state.bin.bad", "state.bin.bad.1", "state.bin.bad.2"}));
  put("state.bin", "four");
  EXPECT_EQ(log_of([&] { file.set_aside("a reason"); }),
            "axisd: " + path + ": a reason; kept as " + path + ".bad.3, the unit starts without it\n");
}

TEST_F(StateFileTest, SetsAsideWhatCannotBeRead) {
  std::filesystem::create_directory(path);

  EXPECT_EQ(log_of([&] { EXPECT_EQ(file.read(), std::nullopt); }),
            "axisd: " + path + ": cannot be read: Is a directory; kept as " + path +
                ".bad, the unit starts without it\n");
}

TEST_F(StateFileTest, SetsAsideWhatIsTooLongToBeOne) {
  std::ofstream{path} << "x";
  std::filesystem::resize_file(path, 17U << 20);

  EXPECT_EQ(log_of([&] { EXPECT_EQ(file.read(), std::nullopt); }),
            "axisd: " + path + ": cannot be read: File too large; kept as " + path +
                ".bad, the unit starts without it\n");
}

TEST_F(StateFileTest, StaysAsItWasWhereThereIsNoRoom) {
  ASSERT_TRUE(file.write(bytes(100, 1), Durability::OnDisk));
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit little{1000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);  // as the daemon does
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &little), 0);

  bool written = true;
  written = file.write(bytes(5000, 2), Durability::OnDisk);

  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(written);
  EXPECT_EQ(file.read(), bytes(100, 1));
  EXPECT_EQ(names(), std::vector<std::string>{"state.bin"});
}

TEST_F(StateFileTest, SaysInOneLineWhatItCouldNotWrite) {
  std::filesystem::create_directory(folder.path("state.bin.new"));

  EXPECT_EQ(log_of([&] { EXPECT_FALSE(file.write(bytes(10, 1), Durability::OnDisk)); }),
            "axisd: " + path + ": cannot be written: Is a directory\n");
}

}  // namespace
}  // namespace axisd
