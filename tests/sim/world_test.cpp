#include "sim/world/world.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "sim/plan/world_plan.hpp"

namespace sim {
namespace {

const axisd::Log& log() {
  static const axisd::Log kLog{axisd::LogLevel{0}};
  return kLog;
}

struct WorldRun {
  std::optional<Breach> breach;
  std::uint64_t digest = 0;
  World::Counts counts;
};

WorldRun run_world(const WorldPlan& plan) {
  World world{plan, log()};
  WorldRun run;
  run.breach = world.run();
  run.digest = world.wire().digest();
  run.counts = world.counts();
  return run;
}

/// One unit with one axis and a master, and nothing that goes wrong.
WorldPlan quiet_plan() {
  WorldPlan plan;
  plan.units.push_back({.heartbeat_ms = 100, .stores = true, .seed = 5});
  plan.units[0].configuration = {{"node_id", 1}, {"axes", {nlohmann::json::object()}}};
  plan.length = std::chrono::seconds{4};
  plan.calm = std::chrono::seconds{1};
  return plan;
}

std::string text_of(const std::optional<Breach>& breach) {
  return breach ? std::string{breach->rule} + ": " + breach->text : "";
}

TEST(World, RunsAUnitWithItsMaster) {
  const WorldRun result = run_world(quiet_plan());
  EXPECT_FALSE(result.breach) << text_of(result.breach);
  EXPECT_GT(result.counts.frames, 200U);
  EXPECT_EQ(result.counts.power_ons, 1U);
}

TEST(World, RepeatsItselfBitForBit) {
  WorldPlan plan = draw_plan(3);
  plan.length = std::chrono::seconds{3};
  const WorldRun first = run_world(plan);
  const WorldRun second = run_world(plan);
  EXPECT_EQ(first.digest, second.digest);
  EXPECT_EQ(first.counts.turns, second.counts.turns);

  WorldPlan other = draw_plan(4);
  other.length = std::chrono::seconds{3};
  EXPECT_NE(run_world(other).digest, first.digest);
}

TEST(World, CutsPowerAndFindsTheSavedSetAgain) {
  WorldPlan plan = quiet_plan();
  plan.length = std::chrono::seconds{20};
  plan.calm = std::chrono::seconds{12};
  for (int i = 1; i <= 6; ++i)
    plan.faults.push_back({.kind = "power.cut",
                           .at = std::chrono::milliseconds{1900 * i},
                           .lasting = std::chrono::milliseconds{50}});
  WorldPlan until_the_last = plan;
  until_the_last.length = plan.faults.back().at - std::chrono::milliseconds{1};
  {
    World world{until_the_last, log()};
    world.run();
    EXPECT_FALSE(world.unit(0).disk().contents_given(world.unit(0).parameter_file()).empty()) << "nothing to find";
  }
  const WorldRun result = run_world(plan);
  EXPECT_FALSE(result.breach) << text_of(result.breach);
  EXPECT_EQ(result.counts.power_ons, 7U);
}

/// Worlds that have shown what was wrong once, each as small as it could be made.
class FoundWorld : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(FoundWorld, IsRightNow) {
  std::ifstream file{GetParam()};
  const auto plan = read_plan(std::string{std::istreambuf_iterator<char>{file}, {}});
  ASSERT_TRUE(plan) << plan.error();
  const WorldRun result = run_world(*plan);
  EXPECT_FALSE(result.breach) << text_of(result.breach);
}

std::vector<std::filesystem::path> found_worlds() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator{FOUND_WORLDS}) paths.push_back(entry.path());
  std::ranges::sort(paths);
  return paths;
}

INSTANTIATE_TEST_SUITE_P(Found, FoundWorld, testing::ValuesIn(found_worlds()), [](const auto& row) {
  std::string name = row.param.stem();
  std::ranges::replace(name, '-', '_');
  return name;
});

}  // namespace
}  // namespace sim
