#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "daemon/control/handlers.hpp"
#include "daemon/instance/instance.hpp"
#include "injection/json/fault_json.hpp"
#include "injection/kinds/unit_kinds.hpp"

namespace axisd {
namespace {

using nlohmann::json;

Outcome add_fault(const Call& call, const json& params) {
  json value = params;
  value.erase("unit");
  const auto fault = injection::read_fault(value, injection::unit_kinds());
  if (!fault) return refuse(control::ErrorCode::BadParameter, fault.error().message());
  const auto id = call.instance.faults().add(*fault);
  if (!id) return refuse(control::ErrorCode::Refused, id.error());
  return json{{"id", *id}};
}

Outcome list_faults(const Call& call, const json&) {
  json faults = json::array();
  for (const injection::Loaded& loaded : call.instance.faults().loaded()) {
    json entry = injection::json_of(loaded.trigger);
    entry["id"] = loaded.id;
    entry["kind"] = loaded.fault.kind->name;
    entry["fault"] = injection::json_of(loaded.fault);
    faults.push_back(std::move(entry));
  }
  return json{{"faults", std::move(faults)}};
}

Outcome remove_faults(const Call& call, const json& params) {
  injection::UnitFaults& faults = call.instance.faults();
  if (!params.contains("id")) return json{{"removed", faults.remove_all()}};
  const auto id = params.at("id").get<std::uint32_t>();
  if (!faults.remove(id))
    return refuse(control::ErrorCode::NotFound, fmt::format("id: no fault has number {}", id));
  return json{{"removed", 1}};
}

Outcome list_kinds(const Call&, const json&) {
  json kinds = json::array();
  for (const injection::Kind& kind : injection::unit_kinds()) kinds.push_back(injection::json_of(kind));
  return json{{"kinds", std::move(kinds)}};
}

constexpr std::array kInjectHandlers{
    Handler{"inject.add", &add_fault},
    Handler{"inject.list", &list_faults},
    Handler{"inject.remove", &remove_faults},
    Handler{"inject.kinds", &list_kinds},
};

}  // namespace

std::span<const Handler> inject_handlers() noexcept {
  return kInjectHandlers;
}

}  // namespace axisd
