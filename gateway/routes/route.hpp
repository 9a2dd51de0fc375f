#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "control/methods.hpp"

namespace gateway {

/// What is done for a route.
enum class Kind : std::uint8_t {
  Call,      ///< a method of the control socket, asked of the unit of the path
  Units,     ///< a method asked of all daemons, the lists put together
  Axis,      ///< what `status` says of one axis
  Events,    ///< a stream of the events of all units
  Recent,    ///< the last events of all units
  Samples,   ///< a stream of the samples of one unit
  Live,      ///< samples and frames of one unit, for who asks again and again
  Frames,    ///< a stream of the frames of one unit
  Metrics,   ///< Prometheus text
  Document,  ///< the OpenAPI file
  Server,    ///< what the gateway is, and what the request may do
  Overview,  ///< what all units do, the same for all who ask
  Eds,       ///< the EDS of one unit
  Start,     ///< the page, or what there is
  Asset      ///< a file of the page
};

/// One row: what stands at a path. The parameters of the method come from the path where that names them, else
/// from the query of a GET or if `in_query` says so, else from the body.
struct Route {
  std::string_view verb;    ///< GET, PUT, POST, PATCH or DELETE
  std::string_view path;    ///< {name} stands for one part
  std::string_view method;  ///< of the control socket; empty: none
  Kind kind = Kind::Call;
  std::string_view ends_with{};  ///< the method that takes back what `method` has begun
  std::array<std::string_view, 2>
      in_query{};              ///< parameters of a PUT, POST, PATCH or DELETE that say what is meant
  std::string_view without{};  ///< the parameter that another route of the method has, or that is asked for here
  std::string_view alias{};    ///< parameter that {alias_of} of the path stands for
  std::string_view alias_of{};
  std::string_view summary{};  ///< one line; empty: that of the method

  /// Whether it changes anything, so that it needs the token. GET is safe (RFC 9110, 9.2.1).
  [[nodiscard]] constexpr bool is_write() const noexcept { return verb != "GET"; }
};

/// What @p route is for, in one line.
[[nodiscard]] constexpr std::string_view summary_of(const Route& route) noexcept {
  const control::Method* const method = route.summary.empty() ? control::find_method(route.method) : nullptr;
  return method == nullptr ? route.summary : method->summary;
}

/// Where a parameter comes from.
enum class ArgumentSource : std::uint8_t { Path, Query, Body, Nowhere };

/// The name that @p key has in the path of @p route.
[[nodiscard]] constexpr std::string_view name_in_path(const Route& route, std::string_view key) noexcept {
  return key == route.alias ? route.alias_of : key;
}

/// Whether {@p name} is a part of @p path.
[[nodiscard]] constexpr bool has_placeholder(std::string_view path, std::string_view name) noexcept {
  for (std::size_t at = path.find('{'); at != std::string_view::npos; at = path.find('{', at + 1)) {
    const std::string_view rest = path.substr(at + 1);
    if (rest.starts_with(name) && rest.substr(name.size()).starts_with('}')) return true;
  }
  return false;
}

/// Where @p key, a parameter of the method of @p route, comes from.
[[nodiscard]] constexpr ArgumentSource source_of(const Route& route, std::string_view key) noexcept {
  if (key == route.without) return ArgumentSource::Nowhere;
  if (has_placeholder(route.path, name_in_path(route, key))) return ArgumentSource::Path;
  const bool is_in_query = route.in_query[0] == key || route.in_query[1] == key;
  return route.verb == "GET" || is_in_query ? ArgumentSource::Query : ArgumentSource::Body;
}

/// What is given in the query beside the parameters of the method: units whose events are wanted.
inline constexpr std::string_view kUnitFilter = "unit";

}  // namespace gateway
