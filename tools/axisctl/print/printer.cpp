#include "tools/axisctl/print/printer.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include "tools/axisctl/print/table.hpp"

namespace axisctl {

namespace {

using nlohmann::json;

constexpr std::size_t kIndent = 2;

bool is_table(const json& value) {
  return value.is_array() && !value.empty() &&
         std::ranges::all_of(value, [](const json& row) { return row.is_object(); });
}

/// The keys of @p objects in the order of @p known, then those that are not known.
std::vector<std::string> keys_of(const json& objects, std::span<const std::string_view> known) {
  std::vector<std::string> keys;
  const auto add = [&keys](std::string_view key) {
    if (std::ranges::count(keys, key) == 0) keys.emplace_back(key);
  };
  const auto has = [](const json& object, std::string_view key) { return object.contains(key); };
  for (const std::string_view key : known)
    if (std::ranges::any_of(objects, [&](const json& object) { return has(object, key); })) add(key);
  for (const json& object : objects)
    for (const auto& item : object.items()) add(item.key());
  return keys;
}

std::string words_of(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

void print_table(std::ostream& out, const json& rows, const control::Method& method, Style style,
                 std::size_t indent) {
  std::vector<std::string> keys;
  const std::span<const std::string_view> wanted =
      style.brief && !method.brief.empty() ? method.brief : method.columns;
  for (const std::string_view key : wanted)
    if (std::ranges::any_of(rows, [&](const json& row) { return row.contains(key); })) keys.emplace_back(key);
  if (keys.empty()) keys = keys_of(rows, method.keys);
  std::vector<std::string> heads;
  heads.reserve(keys.size());
  for (const std::string& key : keys) heads.push_back(words_of(key));
  Table table{std::move(heads)};
  for (const json& row : rows) {
    std::vector<std::string> cells;
    cells.reserve(keys.size());
    for (const std::string& key : keys) cells.push_back(row.contains(key) ? text_of(row[key]) : "");
    table.add(std::move(cells));
  }
  table.print(out, !style.brief, indent);
}

void print_members(std::ostream& out, const json& object, const control::Method& method, Style style,
                   std::size_t indent) {
  const std::string blanks(indent, ' ');
  const json one = json::array({object});
  const auto is_alone = [](const std::string& key) { return key == "total" || key == "next"; };
  const auto tables = std::ranges::count_if(object, [](const json& value) { return value.is_array(); });
  for (const std::string& key : keys_of(one, method.keys)) {
    const json& value = object[key];
    if (tables == 1 && is_alone(key)) continue;
    if (style.brief && tables > 0 && !value.is_array()) continue;
    const bool needs_head = object.size() > 1 && !(tables == 1 && object.contains("total"));
    if (is_table(value)) {
      if (needs_head) out << blanks << words_of(key) << ":\n";
      print_table(out, value, method, style, indent + (needs_head ? kIndent : 0));
    } else if (value.is_object() && !value.empty()) {
      out << blanks << words_of(key) << ":\n";
      print_members(out, value, method, style, indent + kIndent);
    } else {
      out << blanks << key << ": " << text_of(value) << '\n';
    }
  }
}

void print_reasons(std::ostream& out, const json& reasons, const char* indent) {
  for (const json& reason : reasons) out << indent << text_of(reason) << '\n';
}

/// A reason a line, below its axis if all were asked for; the first of them alone if it is to be brief.
void print_explanation(std::ostream& out, const json& result, Style style) {
  if (result.contains("reasons")) {
    json reasons = result["reasons"];
    if (style.brief && reasons.is_array() && reasons.size() > 1) reasons.erase(reasons.begin() + 1, reasons.end());
    return print_reasons(out, reasons, "");
  }
  for (const json& axis : result.value("axes", json::array())) {
    if (!axis.is_object() || !axis.contains("axis") || !axis.contains("reasons")) continue;
    const json& reasons = axis["reasons"];
    out << (style.brief ? "" : "axis ") << text_of(axis["axis"]);
    if (style.brief && !reasons.empty()) out << "  " << text_of(reasons.front());
    out << '\n';
    if (!style.brief) print_reasons(out, reasons, "  ");
  }
}

/// A method whose result is shown in its own way.
struct Printer {
  std::string_view method;
  void (*print)(std::ostream& out, const json& result, Style style);
};
constexpr std::array kPrinters{Printer{"status", print_status}, Printer{"explain", print_explanation},
                               Printer{"state.machine", print_state_machine}, Printer{"audit.get", print_audit}};

/// A beginning of a state, and the colour it is shown in (ECMA-48).
struct StateColour {
  std::string_view state;
  std::string_view colour;
};
constexpr std::array kStateColours{StateColour{"Fault", "\033[31m"}, StateColour{"Operation enabled", "\033[32m"},
                                   StateColour{"Quick stop", "\033[33m"}, StateColour{"OFF1", "\033[33m"},
                                   StateColour{"STOP2", "\033[33m"}};
constexpr std::string_view kPlain = "\033[0m";

}  // namespace

Style style_of_output(bool brief) {
  const char* const no_colour = std::getenv("NO_COLOR");
  return {brief, ::isatty(STDOUT_FILENO) == 1 && (no_colour == nullptr || *no_colour == '\0')};
}

std::string coloured_state(const std::string& state, Style style) {
  const auto* const row = std::ranges::find_if(
      kStateColours, [&](const StateColour& known) { return state.starts_with(known.state); });
  if (!style.colour || row == kStateColours.end()) return state;
  return std::string{row->colour}.append(state).append(kPlain);
}

std::string text_of(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_null()) return "-";
  if (!value.is_structured()) return value.dump();
  std::string text;
  for (const auto& item : value.items()) {
    text += text.empty() ? "" : ", ";
    if (value.is_object()) text.append(item.key()).append(" ");
    text += text_of(item.value());
  }
  return text.empty() ? "none" : text;
}

std::string text_in(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? std::string{} : text_of(*found);
}

void print_result(std::ostream& out, const control::Method& method, const json& result, Style style) {
  const auto* const row = std::ranges::find(kPrinters, method.name, &Printer::method);
  if (row != kPrinters.end()) return row->print(out, result, style);
  if (result.is_object()) return print_members(out, result, method, style, 0);
  if (!result.empty()) out << text_of(result) << '\n';
}

}  // namespace axisctl
