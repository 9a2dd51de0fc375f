// Saving and restoring over the control socket.
#include <gtest/gtest.h>

#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

struct StorageMethods : ControlledUnit {
  double ramp() {
    return result_of("parameter.read", {{"parameters", {"p1120"}}}).at("parameters").at(0).at("value");
  }
  void set_ramp(double seconds) { result_of("parameter.write", {{"parameter", "p1120"}, {"value", seconds}}); }
};

TEST_F(StorageMethods, SaveWhatThePowerOffDoesNotTake) {
  EXPECT_EQ(result_of("store.status").at("is_stored"), false);
  set_ramp(3.0);

  EXPECT_EQ(result_of("store").at("is_saving"), true);
  EXPECT_EQ(error_of("store").code, ErrorCode::Busy);
  EXPECT_EQ(error_of("restore", {{"which", "factory"}}).code, ErrorCode::Busy);
  await_write();

  const json status = result_of("store.status");
  EXPECT_EQ(status.at("is_saving"), false);
  EXPECT_EQ(status.at("is_stored"), true);
  EXPECT_EQ(status.at("saves"), 1);
  EXPECT_EQ(status.at("last_kept"), true);
  EXPECT_EQ(status.at("file"), "in use");
  switch_on(unit_of(1));
  EXPECT_EQ(ramp(), 3.0);
}

TEST_F(StorageMethods, TakeBackWhatWasStoredOrWhatANewUnitHas) {
  set_ramp(3.0);
  result_of("store");
  await_write();
  set_ramp(4.0);

  result_of("restore", {{"which", "stored"}});
  run(std::chrono::milliseconds{20});
  EXPECT_EQ(ramp(), 3.0);
  EXPECT_EQ(sent().front(), "705#00") << "off and on again";

  result_of("restore", {{"which", "factory"}});
  EXPECT_EQ(ramp(), 10.0);
  EXPECT_EQ(error_of("restore", {{"which", "yesterday"}}).code, ErrorCode::BadParameter);
  EXPECT_EQ(error_of("restore").code, ErrorCode::BadParameter);
}

TEST_F(StorageMethods, RefuseAFactoryResetWhileTheMotorRuns) {
  answer("000#0105");
  for (const int controlword : {0x06, 0x07, 0x0F}) {
    result_of("object.write", {{"index", "6040"}, {"value", controlword}});
    run(std::chrono::milliseconds{500});
  }

  EXPECT_EQ(error_of("restore", {{"which", "factory"}}).code, ErrorCode::Refused);
}

}  // namespace
}  // namespace axisd
