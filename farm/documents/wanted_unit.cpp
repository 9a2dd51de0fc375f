#include "farm/documents/wanted_unit.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "farm/documents/field_reader.hpp"

namespace farm {
namespace {

/// What the key of the document says, or the host; and what makes more than one unit of a configuration.
constexpr std::array kForeignKeys{"interface", "node_id", "bus", "units", "threads", "control_group"};

}  // namespace

bool WantedUnit::allows(std::string_view host) const noexcept {
  return hosts.empty() || std::ranges::find(hosts, host) != hosts.end();
}

tl::expected<WantedUnit, std::string> parse_wanted_unit(std::string_view key, std::string_view text) {
  FieldReader fields{key, text};
  fields.allow_only({"configuration", "host"});
  WantedUnit unit{.configuration = fields.object("configuration"), .hosts = fields.names("host")};
  for (const char* const foreign : kForeignKeys)
    if (unit.configuration.contains(foreign))
      fields.fail("configuration", fmt::format("an object without {}", foreign), unit.configuration);
  return fields.result(std::move(unit));
}

std::string text_of(const WantedUnit& unit) {
  nlohmann::json document{{"configuration", unit.configuration}};
  if (unit.hosts.size() == 1)
    document["host"] = unit.hosts.front();
  else if (!unit.hosts.empty())
    document["host"] = unit.hosts;
  return document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace farm
