#include "os/regular_file.hpp"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace os {
namespace {

namespace fs = std::filesystem;
using Why = UnreadableFile::Why;

constexpr std::size_t kMost = 100'000;

/// A folder of its own, gone with the test.
class RegularFileTest : public testing::Test {
 protected:
  RegularFileTest() {
    std::string pattern = (fs::temp_directory_path() / "axisd-os-XXXXXX").string();
    if (mkdtemp(pattern.data()) != nullptr) folder_ = pattern;
  }
  void SetUp() override { ASSERT_FALSE(folder_.empty()); }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string write(const std::string& name, std::size_t bytes) const {
    std::ofstream{path(name)} << std::string(bytes, 'x');
    return path(name);
  }

 private:
  fs::path folder_;
};

TEST_F(RegularFileTest, IsReadWhole) {
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{65536}, kMost}) {
    const auto content = read_regular_file(write("file", bytes), kMost);
    ASSERT_TRUE(content);
    EXPECT_EQ(content->size(), bytes);
  }
}

TEST_F(RegularFileTest, OfProcSaysThatItIsEmptyAndIsReadAllTheSame) {
  const auto content = read_regular_file("/proc/self/status", kMost);
  ASSERT_TRUE(content);
  EXPECT_TRUE(content->starts_with("Name:"));
}

TEST_F(RegularFileTest, ThatIsTooLongIsRefused) {
  const auto content = read_regular_file(write("file", kMost + 1), kMost);
  ASSERT_FALSE(content);
  EXPECT_EQ(content.error().why, Why::TooLong);
  EXPECT_EQ(content.error().reason(), "File too large");
  EXPECT_FALSE(read_regular_file("/dev/zero", kMost));
}

TEST_F(RegularFileTest, ThatIsMissingIsToldApart) {
  const auto content = read_regular_file(path("none"), kMost);
  ASSERT_FALSE(content);
  EXPECT_TRUE(content.error().is_missing());
  EXPECT_EQ(content.error().reason(), "No such file or directory");
}

TEST_F(RegularFileTest, IsNeitherAFolderNorAPipeWithoutAWriter) {
  const auto folder = read_regular_file(path("."), kMost);
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().error, EISDIR);
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), S_IRWXU), 0);
  const auto pipe = read_regular_file(path("pipe"), kMost);
  ASSERT_FALSE(pipe);
  EXPECT_EQ(pipe.error().why, Why::NotRegular);
  EXPECT_FALSE(pipe.error().is_missing());
}

}  // namespace
}  // namespace os
