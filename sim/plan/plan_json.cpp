#include <fmt/format.h>

#include "injection/json/fault_json.hpp"
#include "injection/kinds/bus_kinds.hpp"
#include "injection/kinds/unit_kinds.hpp"
#include "json/strict.hpp"
#include "sim/plan/fault_kinds.hpp"
#include "sim/plan/world_plan.hpp"

namespace sim {
namespace {

using nlohmann::json;
using std::chrono::microseconds;

double milliseconds_of(canopen::Duration time) {
  return std::chrono::duration<double, std::milli>{time}.count();
}

canopen::Duration time_of(const json& value) {
  return std::chrono::duration_cast<canopen::Duration>(
      std::chrono::duration<double, std::milli>{value.get<double>()});
}

json json_of(const UnitPlan& unit) {
  return {{"configuration", unit.configuration},
          {"watched", unit.is_watched},
          {"heartbeat_ms", unit.heartbeat_ms},
          {"inhibit_100us", unit.inhibit_100us},
          {"transmission", unit.transmission},
          {"by_rpdo", unit.by_rpdo},
          {"stores", unit.stores},
          {"restarts", unit.restarts},
          {"guarded", unit.is_guarded},
          {"intruded", unit.is_intruded},
          {"seed", unit.seed}};
}

json json_of(const FaultPlan& fault) {
  json said{{"kind", fault.kind},
            {"at_ms", milliseconds_of(fault.at)},
            {"for_ms", milliseconds_of(fault.lasting)},
            {"unit", fault.unit}};
  if (fault.number != 0) said["number"] = fault.number;
  if (!fault.words.empty()) said["words"] = fault.words;
  return said;
}

UnitPlan unit_of(const json& said) {
  return {.configuration = said.at("configuration"),
          .is_watched = said.value("watched", false),
          .heartbeat_ms = said.value("heartbeat_ms", std::uint16_t{0}),
          .inhibit_100us = said.value("inhibit_100us", std::uint16_t{0}),
          .transmission = said.value("transmission", std::uint8_t{254}),
          .by_rpdo = said.value("by_rpdo", false),
          .stores = said.value("stores", false),
          .restarts = said.value("restarts", false),
          .is_guarded = said.value("guarded", false),
          .is_intruded = said.value("intruded", false),
          .seed = said.value("seed", std::uint64_t{0})};
}

FaultPlan fault_of(const json& said) {
  return {.kind = said.at("kind"),
          .at = time_of(said.at("at_ms")),
          .lasting = time_of(said.value("for_ms", json(0))),
          .unit = said.value("unit", std::size_t{0}),
          .number = said.value("number", std::int64_t{0}),
          .words = said.value("words", std::string{})};
}

/// What keeps @p fault from being one of a world of so many @p units.
std::string objection_to(const FaultPlan& fault, std::size_t units) {
  if (fault.unit >= units) return fmt::format("there is no unit {}", fault.unit);
  const FaultKind* const kind = find_fault_kind(fault.kind);
  if (kind == nullptr) return fmt::format("there is no kind {}", json_text::quote(fault.kind));
  if (kind->source != FaultKind::Source::None) {
    const bool is_of_bus = kind->source == FaultKind::Source::Bus;
    const auto said =
        injection::read_fault_words(fault.words, is_of_bus ? injection::bus_kinds() : injection::unit_kinds());
    if (!said) return fmt::format("words {}: {}", json_text::quote(fault.words), said.error().message());
  }
  if (fault.number < kind->low || fault.number > kind->high)
    return fmt::format("number of {}: expected {} to {}, got {}", kind->name, kind->low, kind->high, fault.number);
  return {};
}

/// What keeps @p plan from being one.
std::string objection_to(const WorldPlan& plan) {
  if (plan.units.empty()) return "units: expected one at least";
  for (const FaultPlan& fault : plan.faults)
    if (const std::string objection = objection_to(fault, plan.units.size()); !objection.empty())
      return "faults: " + objection;
  return {};
}

}  // namespace

json json_of(const WorldPlan& plan) {
  json said{{"seed", plan.seed},
            {"bit_rate", plan.bit_rate},
            {"length_ms", milliseconds_of(plan.length)},
            {"calm_ms", milliseconds_of(plan.calm)},
            {"sync_ms", milliseconds_of(plan.sync)},
            {"units", json::array()},
            {"faults", json::array()}};
  for (const UnitPlan& unit : plan.units) said["units"].push_back(json_of(unit));
  for (const FaultPlan& fault : plan.faults) said["faults"].push_back(json_of(fault));
  return said;
}

tl::expected<WorldPlan, std::string> read_plan(std::string_view text) {
  try {
    const json said = json::parse(text);
    WorldPlan plan{.seed = said.value("seed", std::uint64_t{0}),
                   .bit_rate = said.value("bit_rate", std::uint32_t{500'000}),
                   .length = time_of(said.value("length_ms", json(20'000))),
                   .calm = time_of(said.value("calm_ms", json(12'000))),
                   .sync = time_of(said.value("sync_ms", json(0)))};
    for (const json& unit : said.at("units")) plan.units.push_back(unit_of(unit));
    for (const json& fault : said.value("faults", json::array())) plan.faults.push_back(fault_of(fault));
    if (auto objection = objection_to(plan); !objection.empty()) return tl::unexpected{std::move(objection)};
    return plan;
  } catch (const json::exception& error) {
    return tl::unexpected{std::string{error.what()}};
  }
}

}  // namespace sim
