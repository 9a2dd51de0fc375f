#include "daemon/configuration/axis/load_reader.hpp"

#include <array>
#include <limits>
#include <numbers>

#include "daemon/configuration/base/quantity_keys.hpp"

namespace axisd {
namespace {

using motor::Coupling;
using motor::EndStops;
using motor::HoldingBrake;
using motor::Load;
using Key = QuantityKey<Load>;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kHighestTorque = 1e6;  // N·m
constexpr double kTurn = 2.0 * std::numbers::pi;

template <auto... path>
constexpr auto kNumber = &quantity<Load, path...>;

/// The numbers of one object of the load.
struct Section {
  const char* key;  ///< empty: the load itself
  std::span<const Key> keys;
};
constexpr std::array kOwnKeys{Key{"inertia", "inertia", kNumber<&Load::inertia>}};
constexpr std::array kFrictionKeys{
    Key{"coulomb", "coulomb_friction", kNumber<&Load::coulomb_friction>},
    Key{"viscous", "viscous_friction", kNumber<&Load::viscous_friction>},
    Key{"breakaway", "breakaway_torque", kNumber<&Load::breakaway_torque>},
    Key{"stribeck_speed", "stribeck_speed", kNumber<&Load::stribeck_speed>},
};
constexpr std::array kCouplingKeys{
    Key{"stiffness", "coupling.stiffness", kNumber<&Load::coupling, &Coupling::stiffness>},
    Key{"damping", "coupling.damping", kNumber<&Load::coupling, &Coupling::damping>},
    Key{"backlash", "coupling.backlash", kNumber<&Load::coupling, &Coupling::backlash>},
};
constexpr std::array kEndStopKeys{
    Key{"lower", "end_stops.lower", kNumber<&Load::end_stops, &EndStops::lower>},
    Key{"upper", "end_stops.upper", kNumber<&Load::end_stops, &EndStops::upper>},
    Key{"lower_revolutions", "end_stops.lower", kNumber<&Load::end_stops, &EndStops::lower>, kTurn},
    Key{"upper_revolutions", "end_stops.upper", kNumber<&Load::end_stops, &EndStops::upper>, kTurn},
    Key{"stiffness", "end_stops.stiffness", kNumber<&Load::end_stops, &EndStops::stiffness>},
    Key{"damping", "end_stops.damping", kNumber<&Load::end_stops, &EndStops::damping>},
};
constexpr std::array kBrakeKeys{
    Key{"torque", "brake.torque", kNumber<&Load::brake, &HoldingBrake::torque>},
    Key{"opening_time", "brake.opening_time", kNumber<&Load::brake, &HoldingBrake::opening_time>},
    Key{"closing_time", "brake.closing_time", kNumber<&Load::brake, &HoldingBrake::closing_time>},
};
constexpr std::array kSections{Section{"friction", kFrictionKeys}, Section{"coupling", kCouplingKeys},
                               Section{"end_stops", kEndStopKeys}, Section{"brake", kBrakeKeys}};

/// How a torque is written, and what its numbers are.
struct TorqueKind {
  std::string_view type;
  std::array<std::string_view, 2> keys;  ///< that it must have
  void (*add)(const JsonReader& json, Load& load);
};

double weight_torque(const JsonReader& json) {
  const double torque =
      motor::hoist_torque(json.at("mass").number(0, kUnlimited), json.at("radius").number(0, kUnlimited));
  if (torque > kHighestTorque) json.fail(fmt::format("mass and radius that make at most {} N·m", kHighestTorque));
  return torque;
}

double torque_number(const JsonReader& json) {
  return json.number(-kHighestTorque, kHighestTorque);
}

void add_profile(const JsonReader& json, Load& load) {
  const JsonReader points = json.at("points");
  points.expect_array(1, motor::TorqueProfile::kCapacity);
  motor::TorqueProfile& profile = load.profile;
  profile.count = points.size();
  for (std::size_t i = 0; i < profile.count; ++i) {
    const JsonReader point = points.at(i);
    point.expect_array(2, 2);
    profile.points[i] = {point.at(std::size_t{0}).number(0, kUnlimited), torque_number(point.at(std::size_t{1}))};
    if (i > 0 && !(profile.points[i - 1].time < profile.points[i].time))
      point.at(std::size_t{0}).fail("a time after that of the point before");
  }
  if (json.has("repeats")) profile.repeats = json.at("repeats").boolean();
}

constexpr std::array kTorqueKinds{
    TorqueKind{
        "constant",
        {"torque"},
        [](const JsonReader& json, Load& load) { load.constant_torque += torque_number(json.at("torque")); }},
    TorqueKind{"friction",
               {"torque"},
               [](const JsonReader& json, Load& load) {
                 load.friction_torque += json.at("torque").number(0, kHighestTorque);
               }},
    TorqueKind{"hoist",
               {"mass", "radius"},
               [](const JsonReader& json, Load& load) { load.constant_torque += weight_torque(json); }},
    TorqueKind{"fan",
               {"coefficient"},
               [](const JsonReader& json, Load& load) {
                 load.fan_coefficient += json.at("coefficient").number(0, kUnlimited);
               }},
    TorqueKind{"pendulum",
               {"mass", "radius"},
               [](const JsonReader& json, Load& load) { load.pendulum_torque += weight_torque(json); }},
    TorqueKind{"profile", {"points"}, add_profile},
};

void read_torque(const JsonReader& json, Load& load) {
  if (!json.is_object()) {
    load.constant_torque += torque_number(json);
    return;
  }
  if (!json.has("type")) json.fail("a number (N·m) or an object with the key type");
  const std::string type = json.at("type").text();
  for (const TorqueKind& kind : kTorqueKinds) {
    if (kind.type != type) continue;
    std::vector<std::string_view> keys{"type"};
    for (const std::string_view key : kind.keys)
      if (!key.empty()) keys.push_back(key);
    const std::vector<std::string_view> needed = keys;
    if (type == "profile") keys.emplace_back("repeats");
    json.expect_object(keys);
    for (const std::string_view key : needed)
      if (!json.has(std::string{key})) json.fail(fmt::format("the key {}", key));
    return kind.add(json, load);
  }
  json.at("type").fail("constant, friction, hoist, fan, pendulum or profile");
}

/// Several torques add up.
void read_torques(const JsonReader& json, Load& load) {
  if (!json.is_array()) return read_torque(json, load);
  for (std::size_t i = 0; i < json.size(); ++i) read_torque(json.at(i), load);
}

/// A section with its keys, refused where the load as a whole cannot be.
void read_section(const JsonReader& json, const Section& section, Load& load) {
  std::vector<std::string_view> keys;
  for (const Key& row : section.keys) keys.push_back(row.key);
  json.expect_object(keys);
  refuse_doubles(json, section.keys);
  read_quantities(json, section.keys, load);
  const auto impossible = motor::find_impossible(load);
  for (const Key& row : section.keys)
    if (impossible && impossible->member == row.member) refuse(json, section.keys, impossible);
}

/// Behind a gear with @p ratio revolutions of the motor for one of the load, at the motor shaft instead.
void refer_to_shaft(double ratio, Load& load) {
  const double square = ratio * ratio;
  for (double* const torque :
       {&load.coulomb_friction, &load.breakaway_torque, &load.constant_torque, &load.friction_torque})
    *torque /= ratio;
  for (motor::TorqueProfile::Point& point : load.profile.points) point.torque /= ratio;
  for (double* const per_speed : {&load.inertia, &load.viscous_friction, &load.coupling.stiffness,
                                  &load.coupling.damping, &load.end_stops.stiffness, &load.end_stops.damping})
    *per_speed /= square;
  load.fan_coefficient /= square * ratio;
  for (double* const angle :
       {&load.stribeck_speed, &load.coupling.backlash, &load.end_stops.lower, &load.end_stops.upper})
    *angle *= ratio;
}

void put_behind_gear(const JsonReader& json, double ratio, Load& load) {
  if (load.pendulum_torque > 0.0 && (ratio < 1.0 || ratio > 1.0)) json.fail("1, since there is a pendulum");
  refer_to_shaft(ratio, load);
}

/// Throws at the section whose values are @p impossible for the masses that there are.
void refuse_too_fast(const JsonReader& json, const std::optional<motor::Impossible>& impossible) {
  for (const Section& section : kSections)
    for (const Key& row : section.keys)
      if (impossible && row.member == impossible->member && json.has(section.key))
        refuse(json.at(section.key), section.keys, impossible);
  refuse<Load>(json, kOwnKeys, impossible);
}

}  // namespace

Load read_load(const JsonReader& json, const motor::MachineData& machine, const drive::LoadMechanics& mechanics) {
  json.expect_object({"inertia", "friction", "torque", "coupling", "end_stops", "gear", "pitch", "brake"});
  Load load;
  read_quantities<Load>(json, kOwnKeys, load);
  if (json.has("torque")) read_torques(json.at("torque"), load);
  for (const Section& section : kSections)
    if (json.has(section.key)) read_section(json.at(section.key), section, load);
  refuse<Load>(json, kOwnKeys, motor::find_impossible(load));
  if (json.has("gear")) put_behind_gear(json.at("gear"), mechanics.ratio(), load);
  refuse_too_fast(json, motor::find_impossible(machine, load));
  return load;
}

}  // namespace axisd
