#include "tools/axisctl/printer.hpp"

#include <algorithm>
#include <array>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

namespace axisctl {

namespace {

using nlohmann::json;

void print_members(std::ostream& out, const json& result) {
  if (!result.is_object()) return;
  for (const auto& [key, value] : result.items())
    out << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump()) << '\n';
}

void print_reasons(std::ostream& out, const json& reasons, const char* indent) {
  for (const json& reason : reasons) out << indent << reason.get<std::string>() << '\n';
}

/// A reason a line, below its axis if all were asked for.
void print_explanation(std::ostream& out, const json& result) {
  if (result.contains("reasons")) return print_reasons(out, result["reasons"], "");
  for (const json& axis : result.value("axes", json::array())) {
    out << "axis " << axis.at("axis") << '\n';
    print_reasons(out, axis.at("reasons"), "  ");
  }
}

/// A method whose result is more than names and values.
struct Printer {
  std::string_view method;
  void (*print)(std::ostream& out, const json& result);
};
constexpr std::array kPrinters{Printer{"status", print_status}, Printer{"explain", print_explanation}};

}  // namespace

void print_result(std::ostream& out, std::string_view method, const json& result) {
  const auto* const row = std::ranges::find(kPrinters, method, &Printer::method);
  row == kPrinters.end() ? print_members(out, result) : row->print(out, result);
}

}  // namespace axisctl
