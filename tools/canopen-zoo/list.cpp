#include "tools/canopen-zoo/list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "tools/canopen-zoo/residents.hpp"

namespace zoo {
namespace {

std::string text_list() {
  std::string text;
  for (const WrongSlave& slave : residents())
    text += fmt::format("{:<44} {}{}\n", slave.name, slave.what,
                        slave.found_by.empty() ? "" : fmt::format(" ({})", fmt::join(slave.found_by, ", ")));
  return text;
}

std::string json_list() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const WrongSlave& slave : residents())
    list.push_back({{"name", slave.name}, {"what", slave.what}, {"found_by", slave.found_by}});
  return list.dump(2) + "\n";
}

std::string markdown_list() {
  std::string text =
      "# Slaves of canopen-zoo\n\n"
      "Made by `canopen-zoo --list=markdown`. [canopen-zoo](zoo.md) runs each of them; the checks are those of\n"
      "[canopen-check](conformance-checks.md) that find it, and no others do.\n\n"
      "| name | what is wrong | found by |\n|---|---|---|\n";
  for (const WrongSlave& slave : residents())
    text += fmt::format("| `{}` | {} | {} |\n", slave.name, slave.what,
                        slave.found_by.empty() ? "" : fmt::format("`{}`", fmt::join(slave.found_by, "`, `")));
  return text;
}

}  // namespace

std::string list_of_residents(ListForm form) {
  switch (form) {
    case ListForm::Json:
      return json_list();
    case ListForm::Markdown:
      return markdown_list();
    case ListForm::Text:
      break;
  }
  return text_list();
}

}  // namespace zoo
