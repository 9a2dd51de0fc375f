// r0002, r0046 and the control words beside r0898: another view of the sequence control.
#include <gtest/gtest.h>

#include "tests/drive/axis_inputs.hpp"
#include "tests/drive/wired_axis.hpp"

namespace drive {
namespace {

struct Enable {
  bool AxisInputs::*signal;
  double display;
  unsigned missing;
};

TEST(OperatingDisplay, NamesTheEnableThatIsMissingInOperation) {
  for (const Enable& enable :
       {Enable{&AxisInputs::enable_setpoint, 10.0, 1U << 12}, Enable{&AxisInputs::continue_ramp, 12.0, 1U << 11},
        Enable{&AxisInputs::enable_ramp, 13.0, 1U << 10},
        Enable{&AxisInputs::enable_speed_controller, 11.0, 1U << 30}}) {
    WiredAxis drive;
    drive.inputs.on = true;
    drive.cycles(3);
    EXPECT_EQ(drive.word(2), 0U);
    EXPECT_EQ(drive.word(46), 0U);

    drive.inputs.*enable.signal = false;
    drive.cycles(1);

    EXPECT_EQ(drive.word(2), enable.display);
    EXPECT_EQ(drive.word(46), enable.missing);
  }
}

TEST(OperatingDisplay, ShowsTheHighestOfSeveralCauses) {
  WiredAxis drive;
  drive.inputs.on = true;
  drive.cycles(3);

  drive.inputs.enable_setpoint = false;
  drive.inputs.enable_ramp = false;
  drive.cycles(1);
  EXPECT_EQ(drive.word(2), 13U);
  drive.inputs.no_off2 = false;
  drive.cycles(1);
  EXPECT_EQ(drive.word(2), 42U);
  drive.inputs.no_off3_second = false;
  drive.cycles(1);
  EXPECT_EQ(drive.word(2), 43U);
  drive.axis.inhibit(true);
  EXPECT_EQ(drive.word(2), 46U);
}

TEST(ControlWords, ShowTheInputsOfMessagesAndTorqueControl) {
  WiredAxis drive;
  EXPECT_EQ(drive.word(2138), 0xE400U);
  EXPECT_EQ(drive.word(1406), 0U);

  drive.inputs.no_external_fault_2 = false;
  drive.inputs.acknowledge_2 = true;
  drive.inputs.torque_control = true;
  drive.cycles(1);

  EXPECT_EQ(drive.word(2138), 0xA480U);
  EXPECT_EQ(drive.word(1406), 0x1000U);
}

}  // namespace
}  // namespace drive
