#include "daemon/instance/memory/state_writer.hpp"

#include <cerrno>
#include <future>

#include <gtest/gtest.h>
#include <poll.h>

#include "tests/fakes/flush_hook.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

using Bytes = std::vector<std::byte>;
using Place = StateWriter::Place;

struct StateWriterTest : testing::Test {
  StateWriterTest() { EXPECT_FALSE(writer.take_ended()); }
  /// Waits for the end of a write.
  StateWriter::Ended next() {
    constexpr int kPatience_ms = 20'000;
    pollfd readable{writer.descriptor(), POLLIN, 0};
    EXPECT_EQ(::poll(&readable, 1, kPatience_ms), 1);
    return writer.take_ended().value();
  }
  bool is_told() const {
    pollfd readable{writer.descriptor(), POLLIN, 0};
    return ::poll(&readable, 1, 0) == 1;
  }

  fakes::TemporaryDirectory folder;
  Log log{LogLevel::Info};
  StateFile first{folder.path(), "first.bin", log};
  StateFile second{folder.path(), "second.bin", log};
  StateWriter writer{100};
};

TEST_F(StateWriterTest, DoesNotWaitForTheDisk) {
  std::promise<void> disk;
  const fakes::FlushHook hook{[ready = disk.get_future().share()](int) { return ready.wait(), 0; }};
  Bytes content(100, std::byte{1});

  writer.begin(Place::Parameters, first, content, Durability::OnDisk);
  content.assign(100, std::byte{2});
  writer.begin(Place::Retained, second, content, Durability::InTheCache);

  EXPECT_FALSE(is_told());
  EXPECT_EQ(writer.take_ended(), std::nullopt);
  EXPECT_EQ(first.read().value(), std::nullopt) << "it is there when it is on the disk";
  disk.set_value();
  EXPECT_TRUE(next().outcome);
  writer.finish();
  EXPECT_TRUE(next().outcome);
  EXPECT_EQ(first.read().value(), Bytes(100, std::byte{1}));
  EXPECT_EQ(second.read().value(), Bytes(100, std::byte{2}));
}

TEST_F(StateWriterTest, TellsWhatHasEndedHow) {
  const fakes::FlushHook hook{[](int) { return EIO; }};

  writer.begin(Place::Retained, second, Bytes(10), Durability::OnDisk);
  const StateWriter::Ended ended = next();

  EXPECT_EQ(ended.place, Place::Retained);
  ASSERT_FALSE(ended.outcome);
  EXPECT_EQ(ended.outcome.error().error, EIO);
  EXPECT_EQ(writer.take_ended(), std::nullopt);
  EXPECT_FALSE(is_told());
}

TEST_F(StateWriterTest, EndsWhatHasBegunBeforeItEndsItself) {
  {
    StateWriter brief{100};
    brief.begin(Place::Parameters, first, Bytes(10), Durability::OnDisk);
  }

  EXPECT_EQ(first.read().value(), Bytes(10));
}

}  // namespace
}  // namespace axisd
