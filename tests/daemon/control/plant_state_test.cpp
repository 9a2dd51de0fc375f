// Load, plant, supply and encoder over the control socket, also while the motor turns.
#include <gtest/gtest.h>

#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;
using std::chrono::milliseconds;

struct PlantMethods : ControlledUnit {
  json plant() { return result_of("plant.get", {{"axis", 1}}); }
  double speed() { return plant().at("speed_rpm"); }
  /// The motor turns at 1000 rpm.
  void turn() {
    answer("000#0105");
    result_of("parameter.write", {{"parameter", "p1120"}, {"value", 0.5}});
    result_of("object.write", {{"index", "60FF"}, {"value", 69905067}});
    for (const int controlword : {0x06, 0x07, 0x0F}) {
      result_of("object.write", {{"index", "6040"}, {"value", controlword}});
      run(milliseconds{500});
    }
    run(milliseconds{1000});
    ASSERT_GT(speed(), 100.0);
  }
};

TEST_F(PlantMethods, ShowTheLoad) {
  result_of("load.set", {{"axis", 1}, {"torque_Nm", 1.5}});

  const json load = result_of("load.get", {{"axis", 1}});

  EXPECT_EQ(load.at("torque_Nm"), 1.5);
  EXPECT_EQ(load.at("friction_Nm"), 0.0);
  EXPECT_EQ(load.at("is_elastic"), false);
  EXPECT_EQ(error_of("load.get", {{"axis", 2}}).code, ErrorCode::BadParameter);
}

TEST_F(PlantMethods, ChangeInertiaAndFrictionWithoutAJumpOfTheSpeed) {
  turn();
  const double before = speed();

  result_of("plant.set", {{"axis", 1}, {"load_inertia_kgm2", 0.5}, {"viscous_friction_Nms", 0.001}});

  EXPECT_EQ(speed(), before);
  EXPECT_EQ(plant().at("load_inertia_kgm2"), 0.5);
  EXPECT_EQ(plant().at("viscous_friction_Nms"), 0.001);
  run(milliseconds{4});
  EXPECT_NEAR(speed(), before, 1.0);
}

TEST_F(PlantMethods, TurnAHeavierLoadMoreSlowly) {
  turn();
  result_of("plant.set", {{"axis", 1}, {"load_inertia_kgm2", 5.0}});
  const double before = speed();

  result_of("object.write", {{"index", "6040"}, {"value", 0}});  // coasts
  result_of("load.set", {{"axis", 1}, {"torque_Nm", 1.0}, {"type", "friction"}});
  run(milliseconds{1000});
  const double heavy = before - speed();
  result_of("plant.set", {{"axis", 1}, {"load_inertia_kgm2", 0.5}});
  const double middle = speed();
  run(milliseconds{1000});

  EXPECT_GT(heavy, 0.5);
  EXPECT_GT(middle - speed(), 4.0 * heavy) << "a tenth of the inertia loses its speed about ten times as fast";
}

TEST_F(PlantMethods, WarmInTheSunAtRest) {
  result_of("plant.set", {{"axis", 1}, {"ambient_C", 60}});
  EXPECT_NEAR(plant().at("winding_C").get<double>(), 20.0, 0.1) << "nothing jumps";

  run(std::chrono::hours{10});

  EXPECT_NEAR(plant().at("winding_C").get<double>(), 60.0, 1.0);
}

TEST_F(PlantMethods, RefuseWhatNoPlantHas) {
  EXPECT_EQ(error_of("plant.set", {{"axis", 1}, {"load_inertia_kgm2", -1}}).code, ErrorCode::BadParameter);
  EXPECT_EQ(error_of("plant.set", {{"axis", 1}, {"ambient_C", 101}}).message,
            "ambient_C: expected a number -40 to 100, got 101");
  Configuration configuration = unit_of(1);
  configuration.axes.front().load.inertia = 0.01;
  configuration.axes.front().load.coupling.stiffness = 1000.0;
  switch_on(configuration);
  EXPECT_EQ(error_of("plant.set", {{"axis", 1}, {"load_inertia_kgm2", 0}}).code, ErrorCode::OutOfRange);
  EXPECT_EQ(result_of("load.get", {{"axis", 1}}).at("coupling").at("stiffness_Nm_rad"), 1000.0);
}

TEST_F(PlantMethods, ShowSupplyAndEncoder) {
  result_of("supply.set", {{"line_voltage_V", 230}});
  EXPECT_EQ(result_of("supply.get").at("line_voltage_V"), 230.0);
  EXPECT_GT(result_of("supply.get").at("dc_link_V"), 0.0);

  result_of("encoder.fail", {{"axis", 1}, {"defect", "loss"}});
  run(milliseconds{8});
  EXPECT_EQ(result_of("encoder.get", {{"axis", 1}}).at("defect"), "loss");
  EXPECT_EQ(result_of("encoder.get", {{"axis", 1}}).at("signal_is_lost"), true);
}

}  // namespace
}  // namespace axisd
