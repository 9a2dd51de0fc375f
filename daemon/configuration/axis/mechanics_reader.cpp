#include "daemon/configuration/axis/mechanics_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace axisd {
namespace {

using drive::LoadMechanics;

constexpr double kLowestRatio = 1e-3;
constexpr double kHighestRatio = 1e4;
constexpr double kMicrometres = 1e3;       // in a mm
constexpr double kShortestPitch = 1e-3;    // mm, one length unit
constexpr double kLongestPitch = 2147483;  // mm, what p2506 holds
constexpr int kLastInput = 7;
constexpr double kFarthest = 1e9;  // load revolutions

/// @p ratio as the fraction of the smallest whole numbers that is as near as a parameter shows it.
void set_ratio(double ratio, LoadMechanics& mechanics) {
  constexpr double kNear = 1e-9;                          // of the ratio
  std::array<double, 2> motor{1.0, 0.0}, load{0.0, 1.0};  // the last two fractions
  for (double left = ratio;; left = 1.0 / (left - std::floor(left))) {
    const double whole = std::floor(left);
    motor = {whole * motor[0] + motor[1], motor[0]};
    load = {whole * load[0] + load[1], load[0]};
    if (std::max(motor[0], load[0]) > LoadMechanics::kMostRevolutions) {
      motor[0] = motor[1];
      load[0] = load[1];
      break;
    }
    if (std::abs(motor[0] / load[0] - ratio) <= kNear * ratio) break;
  }
  mechanics.gear_motor = static_cast<std::uint32_t>(motor[0]);
  mechanics.gear_load = static_cast<std::uint32_t>(load[0]);
}

std::uint32_t read_revolutions(const JsonReader& json) {
  return static_cast<std::uint32_t>(json.integer(1, int{LoadMechanics::kMostRevolutions}));
}

/// Revolutions of the motor for one of the load, or for as many as the second number says.
void read_gear(const JsonReader& json, LoadMechanics& mechanics) {
  if (!json.is_array()) return set_ratio(json.number(kLowestRatio, kHighestRatio), mechanics);
  json.expect_array(2, 2);
  mechanics.gear_motor = read_revolutions(json.at(std::size_t{0}));
  mechanics.gear_load = read_revolutions(json.at(std::size_t{1}));
  if (mechanics.ratio() < kLowestRatio || mechanics.ratio() > kHighestRatio)
    json.fail(fmt::format("revolutions of the motor and the load with a ratio of {} to {}", kLowestRatio,
                          kHighestRatio));
}

drive::TravelSwitch read_switch(const JsonReader& json) {
  json.expect_object({"input", "role", "from", "to", "inverted"});
  if (json.has("role")) json.at("role").fail(R"(a unit with "profile": "cia402")");
  for (const char* const key : {"input", "from", "to"})
    if (!json.has(key)) json.fail(fmt::format("the key {}", key));
  drive::TravelSwitch row;
  row.input = static_cast<unsigned>(json.at("input").integer(0, kLastInput));
  row.from = json.at("from").number(-kFarthest, kFarthest);
  row.to = json.at("to").number(-kFarthest, kFarthest);
  if (!(row.from < row.to))
    json.at("to").fail(fmt::format("a number above {}, where the switch begins", row.from));
  if (json.has("inverted")) row.inverted = json.at("inverted").boolean();
  return row;
}

}  // namespace

LoadMechanics read_mechanics(const JsonReader& load) {
  LoadMechanics mechanics;
  if (load.has("gear")) read_gear(load.at("gear"), mechanics);
  if (load.has("pitch"))
    mechanics.pitch = static_cast<std::uint32_t>(
        std::lround(kMicrometres * load.at("pitch").number(kShortestPitch, kLongestPitch)));
  return mechanics;
}

drive::TravelSwitchList read_switches(const JsonReader& json, FedInputs& fed) {
  json.expect_array(0, drive::TravelSwitchList::kMost);
  drive::TravelSwitchList list;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const JsonReader entry = json.at(i);
    list.add(read_switch(entry));
    const auto [known, is_new] = fed.emplace(list.switches[i].input, entry.path());
    if (!is_new) entry.at("input").fail(fmt::format("an input that {} does not feed", known->second));
  }
  return list;
}

}  // namespace axisd
