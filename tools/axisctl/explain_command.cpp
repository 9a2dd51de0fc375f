#include <ostream>

#include "tools/axisctl/command.hpp"

namespace axisctl {

namespace {

void print_reasons(std::ostream& out, const nlohmann::json& reasons, const char* indent) {
  for (const nlohmann::json& reason : reasons) out << indent << reason.get<std::string>() << '\n';
}

}  // namespace

tl::expected<nlohmann::json, std::string> explain_parameters(Words words) {
  if (words[0].empty()) return nlohmann::json::object();
  const auto axis = parse_axis(words[0], 1);
  if (!axis) return tl::unexpected{axis.error()};
  return nlohmann::json{{"axis", *axis}};
}

void print_explanation(std::ostream& out, const nlohmann::json& result) {
  if (result.contains("reasons")) return print_reasons(out, result["reasons"], "");
  for (const nlohmann::json& axis : result.value("axes", nlohmann::json::array())) {
    out << "axis " << axis.at("axis") << '\n';
    print_reasons(out, axis.at("reasons"), "  ");
  }
}

}  // namespace axisctl
