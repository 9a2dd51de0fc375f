#include "sim/disk/simulated_disk.hpp"

#include <cerrno>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>

#include "os/descriptor.hpp"

namespace sim {
namespace {

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span{text});
}

/// Creates @p path with @p text, flushed or not.
void put(SimulatedDisk& disk, const char* path, const std::string& text, bool flushed) {
  const os::Descriptor file{disk.open(path, O_WRONLY | O_CREAT | O_EXCL, 0600)};
  ASSERT_TRUE(file) << path;
  ASSERT_EQ(disk.write(file.get(), bytes_of(text)), static_cast<ssize_t>(text.size()));
  if (!flushed) return;
  ASSERT_EQ(disk.flush(file.get()), 0);
  const os::Descriptor folder{disk.open("/0", O_RDONLY | O_DIRECTORY, 0)};
  ASSERT_EQ(disk.flush(folder.get()), 0);
}

std::string content(SimulatedDisk& disk, const char* path) {
  const auto text = disk.read(path, 1000);
  return text ? *text : "-";
}

TEST(SimulatedDisk, GivesWhatWasWrittenAndKeepsWhatWasFlushed) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SimulatedDisk disk{Draw{seed}};
    put(disk, "/0/a", "first", true);
    EXPECT_EQ(content(disk, "/0/a"), "first");

    disk.cut_power();
    EXPECT_EQ(content(disk, "/0/a"), "-");
    disk.return_power();
    EXPECT_EQ(content(disk, "/0/a"), "first") << "seed " << seed;
  }
}

TEST(SimulatedDisk, LosesTearsOrKeepsWhatWasNot) {
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SimulatedDisk disk{Draw{seed}};
    put(disk, "/0/a", "12", false);
    disk.cut_power();
    disk.return_power();
    seen.insert(content(disk, "/0/a"));
  }
  using namespace std::string_literals;
  EXPECT_EQ(seen, (std::set<std::string>{"-", "", "1", "12", "1\0"s, "\0\0"s}));
}

TEST(SimulatedDisk, KeepsAWholeFileOfAnExchangeThatWasNotFlushed) {
  std::set<std::string> seen;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SimulatedDisk disk{Draw{seed}};
    put(disk, "/0/a", "old", true);
    put(disk, "/0/b", "new", true);
    ASSERT_EQ(disk.exchange("/0/b", "/0/a"), 0);
    EXPECT_EQ(content(disk, "/0/a"), "new");
    disk.cut_power();
    disk.return_power();
    seen.insert(content(disk, "/0/a"));
  }
  EXPECT_EQ(seen, (std::set<std::string>{"old", "new"}));
}

TEST(SimulatedDisk, FailsAtTheOperationThatIsAskedFor) {
  SimulatedDisk disk{Draw{1}};
  disk.fail(DiskFailure::NoSpace, 2);
  const os::Descriptor file{disk.open("/0/a", O_WRONLY | O_CREAT | O_EXCL, 0600)};
  ASSERT_TRUE(file);
  EXPECT_EQ(disk.write(file.get(), bytes_of("1234")), -1);
  EXPECT_EQ(errno, ENOSPC);
  EXPECT_EQ(content(disk, "/0/a"), "12");
  EXPECT_EQ(disk.write(file.get(), bytes_of("34")), 2);

  disk.fail(DiskFailure::ShortWrite, 1);
  EXPECT_EQ(disk.write(file.get(), bytes_of("5678")), 2);
  EXPECT_EQ(content(disk, "/0/a"), "123456");

  disk.fail(DiskFailure::PowerCut, 1);
  EXPECT_EQ(disk.flush(file.get()), -1);
  EXPECT_FALSE(disk.has_power());
  EXPECT_EQ(disk.unlink("/0/a"), -1);
}

TEST(SimulatedDisk, HasTheErrorsOfTheSystem) {
  SimulatedDisk disk{Draw{1}};
  put(disk, "/0/a", "x", true);
  EXPECT_EQ(disk.open("/0/a", O_WRONLY | O_CREAT | O_EXCL, 0600), -1);
  EXPECT_EQ(errno, EEXIST);
  EXPECT_EQ(disk.rename("/0/none", "/0/b"), -1);
  EXPECT_EQ(errno, ENOENT);
  EXPECT_EQ(disk.exchange("/0/a", "/0/none"), -1);
  EXPECT_EQ(errno, ENOENT);
  EXPECT_EQ(disk.unlink("/0/none"), -1);
  EXPECT_EQ(errno, ENOENT);
  disk.fail_reads(1);
  EXPECT_FALSE(disk.read("/0/a", 10));
  EXPECT_TRUE(disk.read("/0/a", 10));
  EXPECT_EQ(disk.read("/0/a", 0).error().error, EFBIG);
}

}  // namespace
}  // namespace sim
