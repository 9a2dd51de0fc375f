// PDOs and the node over the control socket.
#include <gtest/gtest.h>

#include "control/protocol.hpp"
#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;
using std::chrono::milliseconds;

struct BusMethods : ControlledUnit {
  json pdo(const json& params, const std::string& name) {
    const json pdos = result_of("pdo.list", params).at("pdos");
    for (const json& pdo : pdos)
      if (pdo.at("pdo") == name) return pdo;
    ADD_FAILURE() << name << " of " << pdos;
    return {};
  }
};

TEST_F(BusMethods, ShowWhatIsMapped) {
  const json rpdo = pdo({}, "RPDO 1");

  EXPECT_EQ(rpdo.at("axis"), 1);
  EXPECT_EQ(rpdo.at("object"), "1400h");
  EXPECT_EQ(rpdo.at("identifier"), 0x205);
  EXPECT_EQ(rpdo.at("is_active"), true);
  EXPECT_EQ(rpdo.at("mapping").at(0).at("object"), "6040h:00");
  EXPECT_EQ(rpdo.at("mapping").at(0).at("bits"), 16);
  EXPECT_EQ(rpdo.at("mapping").at(0).at("name"), "Controlword");
  EXPECT_FALSE(rpdo.contains("frames")) << "nobody counts";
  EXPECT_TRUE(pdo({}, "TPDO 1").contains("event_time_ms"));
}

TEST_F(BusMethods, CountTheFramesOfPdosWhileSomebodyWatches) {
  EXPECT_EQ(result_of("pdo.list", {{"watch", true}}).at("is_watched"), true);
  answer("000#0105");
  answer("205#0600");
  run(milliseconds{20});
  answer("205#0700");
  run(milliseconds{40});

  const json rpdo = pdo({{"direction", "receive"}}, "RPDO 1");
  EXPECT_EQ(rpdo.at("frames"), 2);
  EXPECT_EQ(rpdo.at("data"), "0700");
  EXPECT_NEAR(rpdo.at("age_s").get<double>(), 0.04, 0.001);
  EXPECT_NEAR(rpdo.at("interval_s").get<double>(), 0.02, 0.001);
  EXPECT_GT(pdo({{"direction", "transmit"}}, "TPDO 1").at("frames"), 0);

  EXPECT_EQ(result_of("pdo.list", {{"watch", false}}).at("is_watched"), false);
  EXPECT_FALSE(pdo({}, "RPDO 1").contains("frames"));
}

TEST_F(BusMethods, ListAllPdosOfEightAxesInPages) {
  switch_on(unit_of(8));
  result_of("pdo.list", {{"watch", true}});
  std::size_t listed = 0;
  json params{{"all", true}};
  for (bool more = true; more;) {
    const json page = result_of("pdo.list", params);
    EXPECT_LE(control::result_line(1, page).size(), control::kMaximumLine);
    listed += page.at("pdos").size();
    more = page.contains("next");
    if (more) params["from"] = page.at("next");
  }

  EXPECT_EQ(listed, 128U);
  const json of_axis = result_of("pdo.list", {{"axis", 3}, {"all", true}});
  for (const json& pdo : of_axis.at("pdos")) EXPECT_EQ(pdo.at("axis"), 3);
  EXPECT_EQ(error_of("pdo.list", {{"axis", 9}}).code, ErrorCode::BadParameter);
  EXPECT_EQ(error_of("pdo.list", {{"watch", 1}}).code, ErrorCode::BadParameter);
}

TEST_F(BusMethods, ShowTheNode) {
  answer("000#0105");
  result_of("object.write", {{"index", "1017"}, {"value", 500}});
  run(milliseconds{1000});

  const json node = result_of("nmt.get");

  EXPECT_EQ(node.at("node_id"), 5);
  EXPECT_EQ(node.at("state"), "Operational");
  EXPECT_EQ(node.at("error_control").at("heartbeat_ms"), 500);
  EXPECT_EQ(node.at("bus").at("state"), "error-active");
  EXPECT_GT(node.at("bus").at("counters").at("sent"), 1);
}

}  // namespace
}  // namespace axisd
