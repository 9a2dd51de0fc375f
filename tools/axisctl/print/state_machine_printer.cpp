#include <ostream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/axisctl/print/printer.hpp"

namespace axisctl {
namespace {

using nlohmann::json;

void print_way(std::ostream& out, const json& way, Style style) {
  const bool is_open = way.value("is_open", false);
  const char* const how = is_open ? "open" : way.value("by_itself", false) ? "by itself" : "";
  out << fmt::format("{:>2}  {}{}{}\n", text_in(way, "number"), coloured_state(text_in(way, "to"), style),
                     *how == '\0' ? "" : ": ", how);
  if (style.brief) return;
  for (const json& condition : way.value("conditions", json::array()))
    if (condition.is_object())
      out << fmt::format("    {} {}\n", condition.value("met", false) ? "[x]" : "[ ]", text_in(condition, "text"));
}

}  // namespace

void print_state_machine(std::ostream& out, const json& result, Style style) {
  const std::string state = text_in(result, "state");
  out << coloured_state(state, style) << '\n';
  for (const json& way : result.value("transitions", json::array()))
    if (way.is_object() && text_in(way, "from") == state) print_way(out, way, style);
}

}  // namespace axisctl
