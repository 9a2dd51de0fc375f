// What is handed over comes into files, or is counted.
#include "record/recorder.hpp"

#include <csignal>
#include <optional>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/fakes/allocation_counter.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/record/recorded.hpp"

namespace record {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr Event kFault{.kind = EventKind::Fault, .object = 2, .axis = 1, .number = 7900};

class ARecorder : public testing::Test {
 protected:
  void start() { recorder.emplace(plan, 0s); }
  /// Ends it, and what it has done.
  Recorder::Status end(Moment now) {
    recorder->stop(now);
    while (!recorder->status().files.is_over) std::this_thread::yield();
    return recorder->status();
  }
  Recorded read(const std::string& name) const { return read_all(content(name)); }
  std::string content(const std::string& name) const { return content_of_file(plan.files.folder / name); }
  void by_faults(Moment before, Moment after) {
    plan.files.by_faults = true;
    plan.before = before;
    plan.after = after;
  }

  fakes::TemporaryDirectory folder;
  Plan plan{.files = plan_in(folder.path("recordings"))};
  std::optional<Recorder> recorder;
};

TEST_F(ARecorder, WritesWhatComesInItsOrder) {
  start();
  EXPECT_EQ(recorder->status().state, Recorder::State::Recording);
  recorder->on_frame(kRequest, false, 1ms);
  recorder->on_event(kFault, 2ms);
  const std::array values{1.0};
  recorder->on_samples(values, 3ms);
  const Recorder::Status status = end(4ms);

  EXPECT_EQ(status.state, Recorder::State::Stopped);
  EXPECT_EQ(status.files.records, 3U);
  EXPECT_EQ(status.lost, 0U);
  const Recorded file = read("run.axrec");
  ASSERT_EQ(file.records.size(), 4U);
  EXPECT_TRUE(std::holds_alternative<FrameRecord>(file.records[0].content));
  EXPECT_TRUE(std::holds_alternative<Event>(file.records[1].content));
  EXPECT_TRUE(std::holds_alternative<SamplesRecord>(file.records[2].content));
  EXPECT_EQ(file.ending, Reader::Ending::Whole);
}

TEST_F(ARecorder, WritesTheRestWhenItIsDestroyed) {
  start();
  recorder->on_frame(kRequest, false, 1ms);
  recorder.reset();
  EXPECT_EQ(read("run.axrec").records.size(), 2U);
}

TEST_F(ARecorder, TakesNothingMoreWhenItIsStopped) {
  start();
  recorder->stop(1ms);
  recorder->on_frame(kRequest, false, 2ms);
  EXPECT_EQ(end(3ms).files.records, 0U);
}

TEST_F(ARecorder, CountsWhatHasNoRoomAndSaysWhere) {
  constexpr std::uint64_t kFrames = 5000;
  plan.queue_bytes = 1000;
  start();
  for (std::uint64_t i = 0; i < kFrames; ++i) recorder->on_frame(kRequest, false, 1ms);
  const Recorder::Status status = end(2ms);

  const Recorded file = read("run.axrec");
  std::uint64_t told = 0;
  for (const Record& record : file.records)
    if (const auto* const lost = std::get_if<LostRecord>(&record.content)) told += lost->records;
  EXPECT_GT(status.lost, 0U);
  EXPECT_EQ(told, status.lost);
  EXPECT_EQ(count<FrameRecord>(file.records) + told, kFrames);
}

TEST_F(ARecorder, StaysWithinItsSize) {
  plan.files.most_bytes = 40000;
  start();
  for (int i = 0; i < 3000; ++i) recorder->on_frame(kRequest, false, 1ms * i);
  const Recorder::Status status = end(4s);

  std::uintmax_t size = 0;
  for (const auto& file : fs::directory_iterator{plan.files.folder}) size += file.file_size();
  EXPECT_LE(size, 40000U);
  EXPECT_GT(status.files.files, 2U);
  const Recorded older = read("run.1.axrec");
  const Recorded newer = read("run.axrec");
  ASSERT_FALSE(older.records.empty());
  EXPECT_EQ(std::get<EndRecord>(older.records.back().content).reason, EndReason::Full);
  EXPECT_EQ(newer.records.front().at, older.records[older.records.size() - 2].at + 1ms);
}

TEST_F(ARecorder, OfFaultsWritesNothingBeforeOne) {
  by_faults(1s, 1s);
  start();
  recorder->on_frame(kRequest, false, 1ms);
  EXPECT_EQ(recorder->status().state, Recorder::State::Armed);
  EXPECT_EQ(end(2s).files.files, 0U);
}

TEST_F(ARecorder, OfFaultsWritesWhatWasAroundEach) {
  by_faults(100ms, 50ms);
  start();
  for (Moment at = 0s; at < 1s; at += 10ms) recorder->on_frame(kRequest, false, at);
  recorder->on_event(kFault, 1s);
  EXPECT_EQ(recorder->status().state, Recorder::State::Recording);
  for (Moment at = 1s; at < 2s; at += 10ms) recorder->on_frame(kSync, true, at);
  EXPECT_EQ(recorder->status().state, Recorder::State::Armed);
  const Recorder::Status status = end(2s);

  EXPECT_EQ(status.faults, 1U);
  const Recorded file = read("run-1.axrec");
  ASSERT_GT(file.records.size(), 2U);
  EXPECT_EQ(file.records.front().at, 900ms);
  EXPECT_EQ(file.records[file.records.size() - 2].at, 1040ms);
  EXPECT_EQ(std::get<EndRecord>(file.records.back().content).reason, EndReason::Over);
}

TEST_F(ARecorder, OfFaultsGoesOnWithTheNextFile) {
  by_faults(10ms, 10ms);
  start();
  for (int fault = 1; fault <= 2; ++fault) {
    const Moment at = fault * 1s;
    recorder->on_event(kFault, at);
    recorder->on_time(at + 10ms);
    while (recorder->status().files.records < static_cast<std::uint64_t>(fault)) std::this_thread::yield();
  }
  end(3s);
  for (const char* const name : {"run-1.axrec", "run-2.axrec"})
    EXPECT_EQ(count<Event>(read(name).records), 1U) << name;
}

TEST_F(ARecorder, AllocatesNothingForWhatComes) {
  by_faults(100ms, 50ms);
  start();
  const std::array values{1.0, 2.0};
  const std::uint64_t before = fakes::allocations();
  for (Moment at = 0s; at < 1s; at += 1ms) {
    recorder->on_frame(kRequest, false, at);
    recorder->on_samples(values, at);
  }
  EXPECT_EQ(fakes::allocations(), before);
}

TEST_F(ARecorder, WhoseFolderCannotBeMadeSaysSoAndGoesOn) {
  plan.files.folder = folder.path("missing") + "/recordings";
  start();
  recorder->on_frame(kRequest, false, 1ms);
  const Recorder::Status status = end(2ms);
  EXPECT_EQ(status.state, Recorder::State::Failed);
  EXPECT_EQ(status.files.error, plan.files.folder.string() + ": No such file or directory");
  EXPECT_EQ(status.files.unwritten, 1U);
}

/// No file may grow beyond @p bytes while it lives, as on a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, SIG_DFL);
  }

 private:
  rlimit before_{};
};

TEST_F(ARecorder, OnAFullDiskSaysSoAndLeavesWhatCanBeRead) {
  std::optional<FullDisk> disk{std::in_place, 1000};
  start();
  for (int i = 0; i < 100; ++i) recorder->on_frame(kRequest, false, 1ms);
  const Recorder::Status status = end(2ms);
  disk.reset();

  EXPECT_EQ(status.state, Recorder::State::Failed);
  EXPECT_NE(status.files.error.find("run.axrec: "), std::string::npos) << status.files.error;
  const Recorded file = read("run.axrec");
  EXPECT_GT(file.records.size(), 10U);
  EXPECT_EQ(file.ending, Reader::Ending::Cut);
}

}  // namespace
}  // namespace record
