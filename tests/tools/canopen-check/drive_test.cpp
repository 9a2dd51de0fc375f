#include <gtest/gtest.h>

#include "eds/document/document.hpp"
#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

/// What the checks that move leave behind, however they end.
namespace conformance_test {
namespace {

constexpr std::int64_t kState = 0x6F, kSwitchOnDisabled = 0x40;

/// The checks of drives against a right one.
struct DriveRun {
  Slave slave{{.drive = DriveFlaws{}}};
  SimulatedWire wire;
  conformance::RunReport report{};

  void operator()() {
    wire.add(slave);
    eds::Findings findings{"right.eds"};
    const eds::Document document = eds::read_document(eds_of(objects_of({.drive = DriveFlaws{}})), findings);
    eds::Description description;
    const conformance::Settings settings = full_settings();
    description.add(eds::read_data_sheet(document, findings), settings.node_id);
    std::vector<const conformance::Check*> checks = conformance::all_checks();
    std::erase_if(checks, [](const conformance::Check* check) { return !check->moves; });
    conformance::Deviations deviations;
    report = conformance::Runner{wire, description, settings, deviations}.run(checks, {});
  }
  std::int64_t value(std::uint16_t index, std::uint8_t sub_index = 0) {
    return slave.dictionary().stored(index, sub_index).value_or(-1);
  }
  void set(std::uint16_t index, std::int64_t value) {
    slave.dictionary().set(*slave.dictionary().lookup(index, 0), value);
  }
};

TEST(ChecksOfDrives, LeaveTheDriveDisabledWithItsModeAndSettings) {
  DriveRun run;
  run.set(0x6060, 3);
  run.set(0x605A, 6);
  run.set(0x607C, 100);
  run.set(0x6081, 1234);
  run();
  EXPECT_EQ(findings_of(run.report), "");
  EXPECT_EQ(run.value(0x6041) & kState, kSwitchOnDisabled);
  EXPECT_EQ(run.value(0x6040), 0);
  EXPECT_EQ(run.value(0x6060), 3);
  EXPECT_EQ(run.value(0x605A), 6);
  EXPECT_EQ(run.value(0x607C), 100);
  EXPECT_EQ(run.value(0x6081), 1234);
  EXPECT_EQ(run.value(0x607D, 1), 0);
}

TEST(ChecksOfDrives, LeaveTheDriveDisabledWhenTheUserInterrupts) {
  DriveRun whole;
  whole();
  constexpr std::size_t kInstants = 100;
  for (std::size_t instant = 1; instant <= kInstants; ++instant) {
    DriveRun run;
    run.wire.interrupt_after(instant * whole.wire.sent() * 9 / (10 * kInstants));
    run();
    ASSERT_EQ(run.report.problem, "interrupted");
    ASSERT_EQ(run.value(0x6041) & kState, kSwitchOnDisabled) << instant;
    ASSERT_EQ(run.value(0x6060), 0) << instant;
    ASSERT_EQ(run.value(0x606C), 0) << instant;
  }
}

TEST(ChecksOfDrives, BeginWithADriveThatIsEnabledOrHasAFault) {
  DriveRun run;
  for (const std::uint8_t word : std::initializer_list<std::uint8_t>{0x06, 0x07, 0x0F})
    run.slave.on_frame({.id = kRequestOf5, .length = 8, .data = {0x2B, 0x40, 0x60, 0, word}}, run.slave.now());
  EXPECT_EQ(run.value(0x6041) & kState, 0x27);
  run();
  EXPECT_EQ(findings_of(run.report), "");
  EXPECT_EQ(run.value(0x6041) & kState, kSwitchOnDisabled);
}

}  // namespace
}  // namespace conformance_test
