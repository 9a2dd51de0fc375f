#include <gtest/gtest.h>

#include "eds/document/document.hpp"
#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

/// What a run leaves behind, however it ends.
namespace conformance_test {
namespace {

using conformance::Outcome;

/// A run of all checks against a right slave, with what happens on the way.
struct TestRun {
  explicit TestRun(const Defect& defect = {}) : slave{defect} {}

  Slave slave;
  SimulatedWire wire;
  conformance::Settings settings = full_settings();
  conformance::Deviations deviations;
  std::string eds = eds_of(right_objects());

  conformance::RunReport operator()() {
    wire.add(slave);
    eds::Findings findings{"right.eds"};
    const eds::Document document = eds::read_document(eds, findings);
    eds::Description description;
    description.add(eds::read_data_sheet(document, findings), settings.node_id);
    const std::vector<const conformance::Check*> checks = conformance::all_checks();
    return conformance::Runner{wire, description, settings, deviations}.run(checks, {});
  }

  /// What every writable number of the slave holds, but for 1003h, which tells what has happened.
  std::map<std::pair<std::uint16_t, std::uint8_t>, std::int64_t> values() {
    std::map<std::pair<std::uint16_t, std::uint8_t>, std::int64_t> held;
    for (const canopen::Entry& entry : slave.dictionary().entries())
      if (entry.size != 0 && entry.readable && entry.writable && entry.index != 0x1003)
        if (const auto value = slave.dictionary().read(entry)) held[{entry.index, entry.sub_index}] = *value;
    return held;
  }
};

/// Frames that a whole run sends.
std::size_t frames_of_a_run() {
  TestRun run;
  (void)run();
  return run.wire.sent();
}

TEST(Runner, LeavesEveryValueAsItWas) {
  TestRun run;
  // Not the factory setting: what was never stored must survive the resets of the checks too.
  const auto set = [&](std::uint16_t index, std::int64_t value) {
    run.slave.dictionary().set(*run.slave.dictionary().lookup(index, 0), value);
  };
  set(kLimited, 42);
  set(kWide, 77);
  const auto before = run.values();
  const conformance::RunReport report = run();
  EXPECT_EQ(run.values(), before);
  EXPECT_TRUE(report.not_restored.empty());
}

TEST(Runner, LeavesEveryValueAsItWasWhenTheUserInterrupts) {
  const std::size_t frames = frames_of_a_run();
  constexpr std::size_t kInstants = 150;
  for (std::size_t instant = 1; instant <= kInstants; ++instant) {
    TestRun run;
    run.slave.dictionary().set(*run.slave.dictionary().lookup(kLimited, 0), 42);
    const auto before = run.values();
    run.wire.interrupt_after(instant * frames / (kInstants + 1));
    const conformance::RunReport report = run();
    ASSERT_EQ(run.values(), before) << "interrupted after frame " << instant * frames / (kInstants + 1);
    ASSERT_EQ(report.problem, "interrupted");
    ASSERT_LE(report.count(Outcome::Broken), 1U);
  }
}

TEST(Runner, SaysThatTheNodeHasGone) {
  TestRun run;
  run.wire.lose_nodes_after(frames_of_a_run() / 2);
  const conformance::RunReport report = run();
  EXPECT_TRUE(report.problem.starts_with("the node is gone since ")) << report.problem;
  EXPECT_TRUE(report.cut_short);
  EXPECT_EQ(report.count(Outcome::Broken), 0U);
  EXPECT_EQ(report.results.back().reason, report.problem);
  EXPECT_EQ(report.results.size(), conformance::all_checks().size());
}

TEST(Runner, SaysThatTheBusWentDown) {
  const std::size_t frames = frames_of_a_run();
  std::size_t broken = 0;
  for (std::size_t tenth = 1; tenth < 10; ++tenth) {
    TestRun run;
    run.wire.go_down_after(tenth * frames / 10);
    const conformance::RunReport report = run();
    EXPECT_TRUE(report.problem.starts_with("the bus is down since ")) << report.problem;
    EXPECT_LE(report.count(Outcome::Broken), 1U);  // 0 between two checks
    broken += report.count(Outcome::Broken);
  }
  EXPECT_GT(broken, 0U);
}

TEST(Runner, SaysThatThereIsNoNode) {
  TestRun run;
  run.settings.node_id = 6;
  const conformance::RunReport report = run();
  EXPECT_FALSE(report.reached);
  EXPECT_EQ(report.problem, "node 6 does not answer an upload of 1000h:00 (request 606h, 1000.0 ms)");
  EXPECT_GE(report.time, std::chrono::seconds{6});
}

/// True if the tester wrote something: an SDO download, or an NMT command.
bool wrote(const TestRun& run, const std::vector<canopen::Frame>& frames) {
  constexpr std::uint8_t kDownload = 0x20;
  return std::ranges::any_of(frames, [&](const canopen::Frame& frame) {
    return frame.id == 0 || (frame.id == 0x600U + run.settings.node_id && (frame.data[0] & 0xE0U) == kDownload);
  });
}

/// A slave that notes what it is sent.
struct Watched {
  std::vector<canopen::Frame> frames;
  Defect defect{.incoming = [this](Slave&, canopen::Frame& frame) {
    frames.push_back(frame);
    return true;
  }};
};

TEST(Runner, WritesNothingToADeviceOfAnotherEds) {
  Watched watched;
  TestRun run{watched.defect};
  constexpr std::string_view kProduct = "ProductNumber=0x10002";
  run.eds.replace(run.eds.find(kProduct), kProduct.size(), "ProductNumber=0x10003");
  const conformance::RunReport report = run();
  EXPECT_EQ(report.problem,
            "the EDS is of another device: 1018h:02 is 00010002h, the EDS says 00010003h; nothing is written");
  EXPECT_FALSE(wrote(run, watched.frames));
}

TEST(Runner, WritesNothingInReadOnlyMode) {
  Watched watched;
  TestRun run{watched.defect};
  run.settings.mode = conformance::Mode::ReadOnly;
  const conformance::RunReport report = run();
  EXPECT_EQ(findings_of(report), "");
  EXPECT_GT(report.count(Outcome::Passed), 0U);
  EXPECT_FALSE(wrote(run, watched.frames));
}

TEST(Runner, StoresAndMovesNothingWithoutPermission) {
  Watched watched;
  TestRun run{watched.defect};
  run.settings.allow_store = run.settings.allow_motion = false;
  (void)run();
  for (const canopen::Frame& frame : watched.frames) {
    const bool download = frame.id == 0x605 && (frame.data[0] & 0xE0U) == 0x20;
    const unsigned index = unsigned{frame.data[1]} | unsigned{frame.data[2]} << 8U;
    EXPECT_FALSE(download && (index == 0x1010 || index == 0x1011)) << std::hex << index;
  }
}

}  // namespace
}  // namespace conformance_test
