/// A face besides the bus: what it writes leads the unit, and what either of them does the other one sees.
#include <array>

#include "tests/device/storage_fixture.hpp"

namespace device {
namespace {

constexpr std::uint8_t kControlUnit = 1;

/// A face that brings a controlword and takes the statusword away.
struct PanelFace final : ::unit::Face {
  explicit PanelFace(::unit::Runner& of) : runner{of} {}
  void bring() noexcept override {
    if (controlword) axis().process_data().received[0] = *controlword;
  }
  void show() noexcept override { statusword = axis().process_data().sent[0]; }
  void show_messages(bool changed) noexcept override { messages += changed ? 1 : 0; }
  void adopt(const ::unit::Replacement& replacement) noexcept override { last = replacement.cause; }
  drive::Axis& axis() const { return runner.unit().axes()[0]; }

  ::unit::Runner& runner;
  std::optional<std::uint16_t> controlword;  ///< none: the bus leads
  std::uint16_t statusword = 0;
  int messages = 0;
  std::optional<::unit::Replacement::Cause> last;
};

struct PanelUnit : TestUnit {
  PanelUnit() {
    auto attached = std::make_unique<PanelFace>(device.runner());
    panel = attached.get();
    device.attach(std::move(attached));
    start_operational();
  }
  /// The panel brings @p controlword; what the unit sends in the cycle that follows.
  Lines brings(std::uint16_t controlword) {
    panel->controlword = controlword;
    device.runner().set_now(unit_time(now));
    device.runner().wake(::unit::mask_of(1));
    return passes(Device::kCycle);
  }
  /// Writes a parameter as a master at the panel does.
  void write(std::uint16_t number, double value) {
    device.runner().tell_time(unit_time(now));
    ASSERT_TRUE(device.runner().unit().object(kControlUnit)->write(number, value));
    device.runner().on_parameter_written(kControlUnit, number);
    device.runner().follow_up();
  }

  PanelFace* panel = nullptr;
};

TEST(FurtherFace, LeadsTheAxisWhileTheBusShowsIt) {
  PanelUnit unit;
  unit.passes(100ms);

  for (const int controlword : {0x0, 0x6, 0x7, 0xF}) unit.brings(static_cast<std::uint16_t>(controlword));
  unit.passes(100ms);

  EXPECT_EQ(unit.statusword() & 0x006F, 0x0027) << "Operation enabled";
  EXPECT_EQ(unit.panel->statusword, unit.statusword());
  EXPECT_EQ(unit.upload(0x6040).number(), 0U) << "no master has written it";
}

TEST(FurtherFace, LeavesTheAxisToTheBusWhenItBringsNothing) {
  PanelUnit unit;

  for (const char* const frame : {"205#0600", "205#0700", "205#0F00"}) unit.cycles_with(frame);

  EXPECT_EQ(unit.panel->statusword & 0x006F, 0x0027);
  EXPECT_EQ(unit.panel->statusword, unit.statusword());
}

TEST(FurtherFace, IsToldOfFaultsThatTheBusSendsToo) {
  PanelUnit unit;
  const int before = unit.panel->messages;

  ASSERT_TRUE(unit.device.raise(1, 7860, 0, unit.now));

  EXPECT_EQ(unit.panel->messages, before + 1);
  EXPECT_NE(unit.upload(0x1001).number(), 0U);
}

TEST(FurtherFace, IsToldWhenAMasterRestoresParameters) {
  PanelUnit unit;

  ASSERT_EQ(unit.download(kRestore, 1, kLoad, 4), 0U);

  EXPECT_EQ(unit.panel->last, ::unit::Replacement::Cause::Restored);
}

TEST(FurtherFace, CommandsTheNodeByAParameter) {
  PanelUnit unit;
  constexpr std::uint16_t kNodeState = 8685;
  constexpr double kPreOperational = 127;
  ASSERT_EQ(unit.device.node().state(), canopen::NmtState::Operational);

  unit.write(kNodeState, kPreOperational);

  EXPECT_EQ(unit.device.node().state(), canopen::NmtState::PreOperational);
}

TEST(FurtherFace, ChangesAnObjectByTheParameterThatItIs) {
  PanelUnit unit;
  constexpr std::uint16_t kHeartbeat = 8606;

  unit.write(kHeartbeat, 250);

  EXPECT_EQ(unit.upload(0x1017).number(), 250U);
}

}  // namespace
}  // namespace device
