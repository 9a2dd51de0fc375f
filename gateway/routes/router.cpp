#include "gateway/routes/router.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "gateway/base/percent.hpp"
#include "gateway/routes/routes.hpp"
#include "json/strict.hpp"

namespace gateway {
namespace {

bool is_placeholder(std::string_view part) noexcept {
  return part.starts_with('{');
}

/// What the placeholders of @p path, a row's, stand for; nothing if @p given is another path.
std::optional<std::vector<PathValue>> values_of(std::string_view path, const std::vector<std::string>& given) {
  const std::vector<std::string_view> parts = segments_of(path);
  if (parts.size() != given.size()) return std::nullopt;
  std::vector<PathValue> values;
  for (std::size_t at = 0; at < parts.size(); ++at) {
    const std::string_view part = parts[at];
    if (is_placeholder(part) && !given[at].empty())
      values.emplace_back(part.substr(1, part.size() - 2), given[at]);
    else if (part != given[at])
      return std::nullopt;
  }
  return values;
}

std::optional<std::vector<std::string>> decoded_segments(std::string_view path) {
  std::vector<std::string> given;
  for (const std::string_view segment : segments_of(path)) {
    auto text = decoded(segment);
    if (!text) return std::nullopt;
    given.push_back(*std::move(text));
  }
  return given;
}

/// The rows of the path that fits best: the one with the fewest placeholders.
std::vector<Match> matches_of(std::string_view path) {
  std::vector<Match> found;
  const auto given = decoded_segments(path);
  if (!given) return found;
  for (const Route& route : routes())
    if (auto values = values_of(route.path, *given)) found.push_back({&route, *std::move(values)});
  std::size_t fewest = SIZE_MAX;
  for (const Match& match : found) fewest = std::min(fewest, match.values.size());
  std::erase_if(found, [fewest](const Match& match) { return match.values.size() != fewest; });
  return found;
}

std::string verbs_of(const std::vector<Match>& matches) {
  std::string verbs;
  for (const Match& match : matches) {
    verbs.append(verbs.empty() ? "" : ", ").append(match.route->verb);
    if (match.route->verb == "GET") verbs.append(", HEAD");
  }
  return verbs.empty() ? verbs : verbs + ", OPTIONS";
}

}  // namespace

std::string_view Match::value(std::string_view name) const noexcept {
  const auto found = std::ranges::find(values, name, &PathValue::first);
  return found == values.end() ? std::string_view{} : std::string_view{found->second};
}

tl::expected<Match, Error> find_route(std::string_view verb, std::string_view path) {
  std::vector<Match> matches = matches_of(path);
  const std::string_view wanted = verb == "HEAD" ? "GET" : verb;
  const auto found = std::ranges::find(matches, wanted, [](const Match& match) { return match.route->verb; });
  if (found != matches.end()) return std::move(*found);
  if (matches.empty())
    return tl::unexpected{refuse(
        Refused::NoSuchPath,
        fmt::format("{}: no such resource; GET /api/v1/openapi.json describes all", json_text::quote(path)))};
  Error error = refuse(Refused::WrongVerb, fmt::format("this resource has {}", verbs_of(matches)));
  error.allow = verbs_of(matches);
  return tl::unexpected{std::move(error)};
}

std::string verbs_of(std::string_view path) {
  return verbs_of(matches_of(path));
}

std::string unit_of(const Match& match) {
  const std::string_view bus = match.value("bus");
  return bus.empty() ? std::string{} : fmt::format("{}/{}", bus, match.value("node"));
}

}  // namespace gateway
