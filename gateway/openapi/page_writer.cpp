#include <stdexcept>

#include <fmt/format.h>

#include "gateway/base/error.hpp"
#include "gateway/openapi/writers.hpp"
#include "gateway/routes/own_parameters.hpp"
#include "gateway/routes/routes.hpp"

namespace gateway {
namespace {

constexpr std::string_view kUnit = "/api/v1/units/{bus}/{node}";
constexpr std::string_view kBegin = "<!-- made from gateway/routes/: begin -->\n";
constexpr std::string_view kEnd = "<!-- made from gateway/routes/: end -->";

/// The parameters of @p route that come from @p source: "`axis`, `kind`".
std::string names_of(const Route& route, ArgumentSource source) {
  std::string names;
  const auto add = [&names](std::string_view name) {
    names.append(names.empty() ? "`" : ", `").append(name).append("`");
  };
  if (route.kind == Kind::Events && source == ArgumentSource::Query) add(kUnitFilter);
  for (const control::Parameter& row : parameters_of(route))
    if (source_of(route, row.key) == source) add(row.key);
  return names;
}

std::string row_of(const Route& route) {
  const std::string path = route.path.starts_with(kUnit) ? fmt::format("UNIT{}", route.path.substr(kUnit.size()))
                                                         : std::string{route.path};
  std::string given = names_of(route, ArgumentSource::Query);
  if (const std::string body = names_of(route, ArgumentSource::Body); !body.empty())
    given += fmt::format("{}body: {}", given.empty() ? "" : "; ", body);
  const std::string_view summary = summary_of(route);
  const std::string method = route.method.empty() ? "" : fmt::format("`{}`", route.method);
  return fmt::format("| `{} {}` | {} | {} | {} |\n", route.verb, path, given, method, summary);
}

std::string error_row(std::string_view code, Status status, std::string_view meaning) {
  return fmt::format("| {} | `{}` | {} |\n", static_cast<unsigned>(status), code, meaning);
}

}  // namespace

std::string write_page() {
  std::string page = "| resource | query and body | control method | |\n|---|---|---|---|\n";
  for (const Route& route : routes()) page += row_of(route);
  page += "\n## Errors\n\n| status | `code` | meaning |\n|---|---|---|\n";
  for (const ErrorRow& row : kRefusals) page += error_row(row.code, row.status, row.meaning);
  for (const ControlStatus& row : kControlStatus) {
    const control::ErrorName& name = control::kErrorNames[static_cast<std::size_t>(row.code)];
    page += error_row(name.name, row.status, name.meaning);
  }
  return page;
}

std::string with_part(std::string_view page, std::string_view part) {
  const std::size_t begin = page.find(kBegin);
  const std::size_t end = page.find(kEnd);
  if (begin == std::string_view::npos || end == std::string_view::npos)
    throw std::runtime_error{"the page has no marks for what is made from gateway/routes/"};
  return fmt::format("{}{}{}", page.substr(0, begin + kBegin.size()), part, page.substr(end));
}

}  // namespace gateway
