#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "injection/kinds/bus_kinds.hpp"
#include "injection/kinds/unit_kinds.hpp"
#include "sim/base/draw.hpp"
#include "sim/plan/fault_kinds.hpp"
#include "sim/plan/world_plan.hpp"

namespace sim {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::size_t kMostUnits = 20, kMostAxes = 8;
/// Axes of a world: what computes in an acceptable time.
constexpr std::size_t kMostAxesOfAll = 24;

/// Many worlds are small, some are as large as they may be.
std::size_t draw_count(Draw& draw, std::size_t most) {
  if (draw.chance(0.05)) return most;
  return 1 + std::min(draw.below(most), draw.below(most));
}

json draw_axis(Draw& draw, bool is_cia402) {
  constexpr std::array kMotors{"1fk7042", "1fk7063", "1ft7044", "1le1003-2k2", "im-2k2", "ipmsm-2k2"};
  json axis = json::object();
  if (draw.chance(0.5)) axis["motor"] = draw.one_of(kMotors);
  if (!is_cia402 && draw.chance(0.3)) axis["type"] = "vector";
  if (draw.chance(0.6))
    axis["load"] = {{"inertia", draw.real(0.0, 0.01)}, {"friction", {{"coulomb", draw.real(0.0, 0.5)}}}};
  if (!is_cia402) axis["parameters"] = {{"p1120", 0.5}, {"p1121", 0.5}, {"p1135", 0.2}};
  return axis;
}

UnitPlan draw_unit(Draw& draw, std::size_t number, std::size_t axes) {
  constexpr std::array<std::uint16_t, 5> kHeartbeats{0, 100, 100, 200, 500};
  constexpr std::array<std::uint16_t, 5> kInhibits{0, 0, 50, 200, 1000};
  constexpr std::array<std::uint8_t, 5> kTransmissions{254, 254, 255, 1, 3};
  constexpr std::array kPeriods{1, 2, 4, 4, 8};
  UnitPlan unit;
  const bool is_cia402 = draw.chance(0.3);
  unit.configuration = {{"node_id", number + 1}, {"axes", json::array()}};
  for (std::size_t axis = 0; axis < axes; ++axis) unit.configuration["axes"].push_back(draw_axis(draw, is_cia402));
  if (is_cia402) {
    unit.configuration["profile"] = "cia402";
  } else {
    unit.configuration["parameters"] = {{"p8848", draw.one_of(kPeriods)}};
  }
  unit.is_watched = draw.chance(0.5);
  unit.heartbeat_ms = draw.one_of(kHeartbeats);
  unit.inhibit_100us = draw.one_of(kInhibits);
  unit.transmission = draw.one_of(kTransmissions);
  unit.by_rpdo = draw.chance(0.5);
  unit.stores = draw.chance(0.6);
  unit.restarts = draw.chance(0.4);
  unit.is_guarded = draw.chance(0.15);
  unit.is_intruded = draw.chance(0.15);
  unit.seed = draw.below(1'000'000'000);
  return unit;
}

/// Bounds within which an argument is drawn: what makes a fault of a world that is to come to an end.
struct Bounds {
  injection::Argument argument;
  std::int64_t low;
  std::int64_t high;
};
constexpr auto kBounds = std::to_array<Bounds>({
    {injection::Argument::DelayMs, 1, 500},
    {injection::Argument::PeriodMs, 5, 200},
    {injection::Argument::PeriodUs, 300, 5000},
    {injection::Argument::Percent, 5, 90},
    {injection::Argument::BitRate, 50'000, 1'000'000},
    {injection::Argument::Axis, 1, 1},
    {injection::Argument::Pdo, 1, 4},
    {injection::Argument::Server, 1, 1},
    {injection::Argument::Step, 1, 4},
    {injection::Argument::Id, 0, 0x7FF},
    {injection::Argument::Mask, 0, 0x7FF},
    {injection::Argument::NodeId, 30, 100},
    {injection::Argument::First, 1, 1},
    {injection::Argument::Second, 2, 2},
});

std::string draw_argument(Draw& draw, injection::Argument argument, std::size_t units) {
  const injection::ArgumentRow& row = injection::row_of(argument);
  if (row.form == injection::Form::Text) return fmt::format(" {}={}", row.key, draw.below(units) + 1);
  const auto* const bounds = std::ranges::find(kBounds, argument, &Bounds::argument);
  const std::int64_t value =
      bounds != kBounds.end() ? draw.between(bounds->low, bounds->high) : draw.between(row.low, row.high);
  if (row.form == injection::Form::Word)
    return fmt::format(" {}={}", row.key, row.words[static_cast<std::size_t>(value)]);
  if (row.form == injection::Form::Hexadecimal) return fmt::format(" {}=0x{:X}", row.key, value);
  return fmt::format(" {}={}", row.key, value);
}

/// A fault of @p kind as one would write it; what is not required is left out mostly.
std::string draw_words(Draw& draw, const injection::Kind& kind, std::size_t units, canopen::Duration lasting) {
  std::string words{kind.name};
  for (const injection::ArgumentUse& use : kind.arguments)
    if (use.absent.empty() || draw.chance(0.2)) words += draw_argument(draw, use.argument, units);
  if (kind.nature != injection::Nature::Moment) words += fmt::format(" for_ms={}", lasting / milliseconds{1});
  if (kind.nature == injection::Nature::Each && draw.chance(0.7))
    words += fmt::format(" probability={:.2f} seed={}", draw.real(0.02, 0.9), draw.below(1'000'000));
  return words;
}

FaultPlan draw_fault(Draw& draw, const WorldPlan& plan) {
  constexpr std::int64_t kShortest = 5, kLongest = 1500;  // ms
  const auto kinds = fault_kinds();
  const FaultKind& kind =
      draw.chance(0.4) ? kinds[draw.below(2)] : draw.one_of(kinds);  // the wire has most of them
  FaultPlan fault;
  fault.kind = kind.name;
  fault.at = milliseconds{draw.between(200, plan.calm / milliseconds{1} - kLongest)};
  fault.lasting = milliseconds{draw.between(kShortest, kLongest)};
  fault.unit = draw.below(plan.units.size());
  fault.number = draw.between(kind.low, kind.high);
  if (kind.source == FaultKind::Source::Bus)
    fault.words = draw_words(draw, draw.one_of(injection::bus_kinds()), plan.units.size(), fault.lasting);
  if (kind.source == FaultKind::Source::Unit)
    fault.words = draw_words(draw, draw.one_of(injection::unit_kinds()), plan.units.size(), fault.lasting);
  return fault;
}

/// Masters ask each axis 20 times a second.
std::uint32_t draw_bit_rate(Draw& draw, std::size_t axes) {
  constexpr std::array<std::uint32_t, 4> kBitRates{125'000, 250'000, 500'000, 1'000'000};
  const std::size_t slowest = axes > 12 ? 3 : axes > 6 ? 2 : axes > 3 ? 1 : 0;
  return kBitRates[slowest + draw.below(kBitRates.size() - slowest)];
}

}  // namespace

WorldPlan draw_plan(std::uint64_t seed) {
  Draw draw{seed};
  WorldPlan plan;
  plan.seed = seed;
  const std::size_t units = draw_count(draw, kMostUnits);
  std::size_t axes = 0;
  for (std::size_t number = 0; number < units; ++number) {
    const std::size_t left = kMostAxesOfAll - axes - (units - number - 1);
    const std::size_t own = std::min(left, draw_count(draw, kMostAxes));
    plan.units.push_back(draw_unit(draw, number, own));
    axes += own;
  }
  plan.bit_rate = draw_bit_rate(draw, axes);
  if (draw.chance(0.5)) plan.sync = milliseconds{draw.between(4, 50)};
  const std::size_t faults = 1 + draw.below(6);
  for (std::size_t i = 0; i < faults; ++i) plan.faults.push_back(draw_fault(draw, plan));
  return plan;
}

std::string summary_of(const WorldPlan& plan) {
  std::size_t axes = 0;
  for (const UnitPlan& unit : plan.units)
    axes += unit.configuration.value("axes", json::array({json::object()})).size();
  return fmt::format("{} units, {} axes, {} kbit/s, {} s, {} faults", plan.units.size(), axes,
                     plan.bit_rate / 1000, plan.length / seconds{1}, plan.faults.size());
}

}  // namespace sim
