#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "daemon/configuration/axis/motor_file.hpp"
#include "motor/validation/validation.hpp"
#include "tests/daemon/configuration/parse.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

/// The machine of an axis that names @p preset.
motor::MachineData machine_of(const std::string& preset) {
  return parse_configuration(R"({"axes": [{"motor": ")" + preset + R"("}]})", "node.json").axes.at(0).machine;
}

nlohmann::json json_file(const std::string& name) {
  return nlohmann::json::parse(std::ifstream{std::string{SOURCE_FOLDER "/motors/"} + name});
}

TEST(MotorPresets, AreThreeServoMotorsAndTwoInductionMotorsAtLeast) {
  int servos = 0;
  int others = 0;
  for (const std::string& name : MotorFolders{}.presets())
    (machine_of(name).type == motor::MachineType::Synchronous ? servos : others)++;

  EXPECT_GE(servos, 3);
  EXPECT_GE(others, 2);
}

TEST(MotorPresets, SayWhereTheirDataComeFrom) {
  for (const std::string& name : MotorFolders{}.presets()) {
    const nlohmann::json preset = json_file(name + ".json");
    for (const char* const key : {"description", "source", "confidence"})
      EXPECT_GT(preset.value(key, std::string{}).size(), 20U) << name << ": " << key;
  }
}

TEST(MotorPresets, HaveInTheDefaultOneTheMachineOfAUnitOfWhichNothingIsSaid) {
  motor::MachineData preset = machine_of("1fk7063");
  motor::MachineData standard;

  EXPECT_EQ(preset.type, standard.type);
  EXPECT_EQ(preset.pole_pairs, standard.pole_pairs);
  for (const QuantityKey<motor::MachineData>& row : motor_keys())
    EXPECT_DOUBLE_EQ(row.value(preset), row.value(standard)) << row.key;
  EXPECT_EQ(preset.encoder.type, standard.encoder.type);
  EXPECT_EQ(preset.encoder.pulses, standard.encoder.pulses);
  EXPECT_EQ(preset.encoder.fine_bits, standard.encoder.fine_bits);
}

TEST(MotorPresets, HaveRatedTorqueAndSpeedThatMakeTheRatedPower) {
  for (const std::string& name : MotorFolders{}.presets()) {
    const motor::MachineData m = machine_of(name);
    EXPECT_NEAR(m.rated_torque * m.rated_speed / m.rated_power, 1.0, 0.01) << name;
    const double synchronous = m.rated_frequency * 2.0 * 3.14159265358979 / m.pole_pairs;
    const double slip = 1.0 - m.rated_speed / synchronous;
    EXPECT_GE(slip, -1e-3) << name;
    EXPECT_LE(slip, m.type == motor::MachineType::Synchronous ? 1e-3 : 0.06) << name;
  }
}

TEST(MotorPresets, OfTheUserComeFirstAndNeedNoBuild) {
  const fakes::TemporaryDirectory folder;
  std::filesystem::create_directories(folder.path("axisd/motors"));
  std::ofstream{folder.path("axisd/motors/mine.json")} << R"({"rated_speed_rpm": 1000})";
  std::ofstream{folder.path("axisd/motors/1fk7042.json")} << R"({"rated_speed_rpm": 2000})";
  const char* const before = std::getenv("XDG_CONFIG_HOME");
  const std::string kept = before == nullptr ? "" : before;
  setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);

  const motor::MachineData mine = machine_of("mine");
  const motor::MachineData changed = machine_of("1fk7042");
  const std::set<std::string> presets = MotorFolders{}.presets();

  before == nullptr ? unsetenv("XDG_CONFIG_HOME") : setenv("XDG_CONFIG_HOME", kept.c_str(), 1);
  EXPECT_DOUBLE_EQ(mine.rated_speed, 1000.0 * motor::kRpm);
  EXPECT_DOUBLE_EQ(changed.rated_speed, 2000.0 * motor::kRpm);
  EXPECT_EQ(std::ranges::count(presets, "mine"), 1);
  EXPECT_EQ(std::ranges::count(presets, "1fk7042"), 1);
}

TEST(MotorSchema, HasTheKeysThatMotorFilesCanHave) {
  std::set<std::string> keys{"description", "source", "confidence", "type", "pole_pairs", "encoder"};
  for (const QuantityKey<motor::MachineData>& row : motor_keys()) keys.emplace(row.key);
  std::set<std::string> described;
  const nlohmann::json schema = json_file("motor.schema.json");
  for (const auto& item : schema.at("properties").items()) described.insert(item.key());

  EXPECT_EQ(described, keys);
}

}  // namespace
}  // namespace axisd
