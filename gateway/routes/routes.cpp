#include "gateway/routes/routes.hpp"

namespace gateway {
namespace {

constexpr std::array kRoutes{
    Route{.verb = "GET", .path = "/", .method = "", .kind = Kind::Start, .summary = "Names what there is"},
    Route{.verb = "GET",
          .path = "/metrics",
          .method = "",
          .kind = Kind::Metrics,
          .summary = "Metrics of all units and of the gateway, Prometheus text"},
    Route{.verb = "GET",
          .path = "/api/v1/openapi.json",
          .method = "",
          .kind = Kind::Document,
          .summary = "This description, OpenAPI 3.1"},
    Route{.verb = "GET",
          .path = "/api/v1/events",
          .method = "events.subscribe",
          .kind = Kind::Events,
          .ends_with = "events.unsubscribe",
          .summary = "Stream of what happens in all units, or in some"},
    Route{.verb = "GET",
          .path = "/api/v1/units",
          .method = "units",
          .kind = Kind::Units,
          .summary = "List the units of all daemons"},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}", .method = "status"},
    Route{.verb = "GET",
          .path = "/api/v1/units/{bus}/{node}/axes/{axis}",
          .method = "status",
          .kind = Kind::Axis,
          .summary = "Show what an axis does"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/explain", .method = "explain"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/metrics", .method = "metrics"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/power/on", .method = "unit.on"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/power/off", .method = "unit.off"},
    Route{.verb = "POST",
          .path = "/api/v1/units/{bus}/{node}/quit",
          .method = "quit",
          .summary = "Switch all units of the daemon off that runs this unit, and end it"},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/faults", .method = "fault.list"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/faults", .method = "fault.buffer"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/faults", .method = "fault.inject"},
    Route{.verb = "DELETE",
          .path = "/api/v1/units/{bus}/{node}/axes/{axis}/faults",
          .method = "fault.clear",
          .in_query = {"kind"}},
    Route{.verb = "POST",
          .path = "/api/v1/units/{bus}/{node}/axes/{axis}/faults/acknowledge",
          .method = "fault.ack"},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/injected", .method = "inject.list"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/injected", .method = "inject.add"},
    Route{.verb = "DELETE",
          .path = "/api/v1/units/{bus}/{node}/injected",
          .method = "inject.remove",
          .in_query = {"id"}},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/injected/kinds", .method = "inject.kinds"},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/parameters", .method = "parameter.search"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/parameters/diff", .method = "parameter.diff"},
    Route{.verb = "GET",
          .path = "/api/v1/units/{bus}/{node}/parameters/{parameter}",
          .method = "parameter.read",
          .alias = "parameters",
          .alias_of = "parameter"},
    Route{.verb = "PUT",
          .path = "/api/v1/units/{bus}/{node}/parameters/{parameter}",
          .method = "parameter.write",
          .in_query = {"axis"}},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/parameters", .method = "parameter.list"},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/objects", .method = "object.list"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/objects/{index}", .method = "object.read"},
    Route{.verb = "PUT",
          .path = "/api/v1/units/{bus}/{node}/objects/{index}",
          .method = "object.write",
          .in_query = {"sub_index"}},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/supply", .method = "supply.get"},
    Route{.verb = "PUT", .path = "/api/v1/units/{bus}/{node}/supply", .method = "supply.set"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/load", .method = "load.get"},
    Route{.verb = "PUT", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/load", .method = "load.set"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/encoder", .method = "encoder.get"},
    Route{.verb = "PUT", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/encoder", .method = "encoder.fail"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/plant", .method = "plant.get"},
    Route{.verb = "PATCH", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/plant", .method = "plant.set"},

    Route{
        .verb = "GET", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/state-machine", .method = "state.machine"},
    Route{.verb = "GET",
          .path = "/api/v1/units/{bus}/{node}/axes/{axis}/identification",
          .method = "identification.get"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/panel", .method = "panel.get"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/panel", .method = "panel.take"},
    Route{.verb = "PUT", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/panel", .method = "panel.set"},
    Route{.verb = "DELETE", .path = "/api/v1/units/{bus}/{node}/axes/{axis}/panel", .method = "panel.release"},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/terminals/inputs", .method = "input.list"},
    Route{.verb = "PUT", .path = "/api/v1/units/{bus}/{node}/terminals/inputs/{input}", .method = "input.set"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/terminals/outputs", .method = "output.list"},
    Route{.verb = "PUT", .path = "/api/v1/units/{bus}/{node}/terminals/analog", .method = "input.analog"},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/pdos", .method = "pdo.list", .without = "watch"},
    Route{.verb = "POST",
          .path = "/api/v1/units/{bus}/{node}/pdos/watch",
          .method = "pdo.list",
          .summary = "Begin or end to count the frames of PDOs, and show them"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/nmt", .method = "nmt.get"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/bus/restart", .method = "bus.restart"},

    Route{.verb = "GET",
          .path = "/api/v1/units/{bus}/{node}/if1/{do}",
          .method = "if1.exchange",
          .without = "received",
          .summary = "Look at the process data of a drive object on IF1"},
    Route{.verb = "PUT", .path = "/api/v1/units/{bus}/{node}/if1/{do}", .method = "if1.exchange"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/ds47", .method = "parameter.record"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/pkw", .method = "pkw.exchange"},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/signals", .method = "signal.list"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/signals/values", .method = "signal.read"},
    Route{.verb = "GET",
          .path = "/api/v1/units/{bus}/{node}/samples",
          .method = "samples.subscribe",
          .kind = Kind::Samples,
          .ends_with = "samples.unsubscribe",
          .summary = "Stream of what signals are, again and again"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/trace", .method = "trace.status"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/trace/start", .method = "trace.start"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/trace/stop", .method = "trace.stop"},
    Route{.verb = "GET",
          .path = "/api/v1/units/{bus}/{node}/trace/data",
          .method = "trace.read",
          .summary = "Read a result of the trace"},
    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/recording", .method = "record.status"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/recording/start", .method = "record.start"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/recording/stop", .method = "record.stop"},

    Route{.verb = "GET", .path = "/api/v1/units/{bus}/{node}/storage", .method = "store.status"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/storage/store", .method = "store"},
    Route{.verb = "POST", .path = "/api/v1/units/{bus}/{node}/storage/restore", .method = "restore"},
};

constexpr bool is_method(std::string_view name) noexcept {
  return std::ranges::any_of(control::kMethods,
                             [&](const control::Method& method) { return method.name == name; });
}

/// Whether @p route asks for what there is.
constexpr bool is_sound(const Route& route) noexcept {
  if (!route.ends_with.empty() && !is_method(route.ends_with)) return false;
  return route.method.empty() ? !route.summary.empty() : is_method(route.method);
}
static_assert(std::ranges::all_of(kRoutes, is_sound));

}  // namespace

std::span<const Route> routes() noexcept {
  return kRoutes;
}

}  // namespace gateway
