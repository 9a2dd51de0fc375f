#include "daemon/instance/memory/state_files.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "tests/fakes/flush_hook.hpp"
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
  /// What read() gives, which must not fail.
  std::optional<Bytes> content() const {
    auto found = file.read();
    EXPECT_TRUE(found) << found.error();
    return found.value_or(std::nullopt);
  }
  /// Why it cannot be read.
  std::string reason() const {
    const auto found = file.read();
    return found ? "" : found.error();
  }
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
  EXPECT_EQ(log_of([&] { EXPECT_EQ(content(), std::nullopt); }), "");
}

TEST_F(StateFileTest, GivesBackWhatWasWrittenLast) {
  for (const Durability durability : {Durability::OnDisk, Durability::InTheCache}) {
    ASSERT_TRUE(file.write(bytes(200000, 1), durability));
    ASSERT_TRUE(file.write(bytes(100, 2), durability));

    EXPECT_EQ(content(), bytes(100, 2));
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

  EXPECT_EQ(content(), bytes(10, 1));
  ASSERT_TRUE(file.write(bytes(10, 2), Durability::OnDisk));

  EXPECT_EQ(content(), bytes(10, 2));
  EXPECT_EQ(names(), std::vector<std::string>{"state.bin"});
}

TEST_F(StateFileTest, IsWholeForAReaderAtEveryMoment) {
  constexpr std::size_t kSize = 50000;
  ASSERT_TRUE(file.write(bytes(kSize, 0), Durability::InTheCache));
  std::jthread writer{[this] {
    for (int i = 1; i <= 200; ++i) EXPECT_TRUE(file.write(bytes(kSize, i), Durability::InTheCache));
  }};

  for (int i = 0; i < 200; ++i) {
    const auto found = content();
    ASSERT_TRUE(found);
    ASSERT_EQ(found->size(), kSize);
    EXPECT_EQ(found->front(), found->back());
  }
}

TEST_F(StateFileTest, IsSetAsideWithoutLosingAnything) {
  for (const char* const text : {"one", "two", "three"}) {
    put("state.bin", text);
    EXPECT_TRUE(file.set_aside(".bad"));
  }

  EXPECT_EQ(content(), std::nullopt);
  EXPECT_EQ(names(), (std::vector<std::string>{"state.bin.bad", "state.bin.bad.1", "state.bin.bad.2"}));
  put("state.bin", "four");
  EXPECT_EQ(file.set_aside(".old"), path + ".old");
}

TEST_F(StateFileTest, StaysWhereItIsIfItCannotBeRead) {
  std::filesystem::create_directory(path);
  EXPECT_EQ(reason(), "Is a directory");
  std::filesystem::remove(path);
  std::filesystem::create_symlink("state.bin", path);
  EXPECT_EQ(reason(), "Too many levels of symbolic links");
  std::filesystem::remove(path);
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  EXPECT_EQ(reason(), "Not a regular file");

  EXPECT_EQ(names(), std::vector<std::string>{"state.bin"});
}

TEST_F(StateFileTest, IsNotReadIfItIsTooLongToBeOne) {
  std::ofstream{path} << "x";
  std::filesystem::resize_file(path, 17U << 20);

  EXPECT_EQ(reason(), "File too large");
}

TEST_F(StateFileTest, WritesThroughNoLinkThatSomebodyHasLeftThere) {
  put("precious", "precious");
  std::filesystem::create_symlink("precious", folder.path("state.bin.new"));

  ASSERT_TRUE(file.write(bytes(10, 1), Durability::OnDisk));

  EXPECT_EQ(content(), bytes(10, 1));
  EXPECT_EQ(std::filesystem::file_size(folder.path("precious")), 8U);
  EXPECT_FALSE(std::filesystem::is_symlink(path));
}

TEST_F(StateFileTest, HasTheFormerContentAfterAFailureAtAnyFlush) {
  for (const bool there_before : {true, false}) {
    for (const int failing : {0, 1}) {  // the file, its folder
      std::filesystem::remove(path);
      if (there_before) {
        ASSERT_TRUE(file.write(bytes(10, 1), Durability::OnDisk));
      }
      int flush = 0;
      const fakes::FlushHook hook{[&](int) { return flush++ == failing ? EIO : 0; }};

      const auto written = file.write(bytes(10, 2), Durability::OnDisk);

      ASSERT_FALSE(written);
      EXPECT_EQ(written.error().error, EIO);
      EXPECT_EQ(content(), there_before ? std::optional{bytes(10, 1)} : std::nullopt);
      EXPECT_EQ(names().size(), there_before ? 1U : 0U);
    }
  }
}

TEST_F(StateFileTest, StaysAsItWasWhereThereIsNoRoom) {
  ASSERT_TRUE(file.write(bytes(100, 1), Durability::OnDisk));
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const rlimit little{1000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);  // as the daemon does
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &little), 0);

  const bool written = file.write(bytes(5000, 2), Durability::OnDisk).has_value();

  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(written);
  EXPECT_EQ(content(), bytes(100, 1));
  EXPECT_EQ(names(), std::vector<std::string>{"state.bin"});
}

TEST_F(StateFileTest, SaysInOneLineWhatItCouldNotWrite) {
  std::filesystem::create_directory(folder.path("state.bin.new"));

  const auto written = file.write(bytes(10, 1), Durability::OnDisk);

  ASSERT_FALSE(written);
  EXPECT_EQ(log_of([&] { file.report(written.error()); }),
            "axisd: " + path + ": cannot be written: Is a directory\n");
}

}  // namespace
}  // namespace axisd
