// Requests that come in through the control socket and over HTTP.
#include <fmt/format.h>

#include "control/methods.hpp"
#include "control/protocol.hpp"
#include "control/request_check.hpp"
#include "gateway/routes/arguments.hpp"
#include "gateway/routes/router.hpp"
#include "tests/daemon/control/controlled_unit.hpp"
#include "tests/fuzz/readers/readers.hpp"

namespace fuzz {
namespace {

/// A unit that is asked line by line, and goes on meanwhile.
class AskedUnit final : public axisd::ControlledUnit {
 public:
  std::string rule_of(std::string_view line) {
    const auto request = control::parse_request(line);
    if (!request) return message_rule(request.error().error.message);
    const control::Method* const method = control::find_method(request->method);
    if (method == nullptr) return "";
    if (const auto fits = control::check(*method, request->params, kAxes); !fits)
      return message_rule(fits.error());
    const axisd::Outcome outcome = ask(request->method, request->params);
    run(std::chrono::milliseconds{2});
    if (!outcome) return message_rule(outcome.error().message);
    const std::string said = control::result_line(request->id, *outcome);
    if (said.size() > control::kMaximumLine) return fmt::format("an answer of {} bytes to {}", said.size(), line);
    return control::parse_line(said.substr(0, said.size() - 1)).is_discarded() ? fmt::format("{} is no line", said)
                                                                               : "";
  }
  void TestBody() override {}

 private:
  static constexpr std::size_t kAxes = 1;
};

gateway::Query query_in(std::string_view text) {
  gateway::Query query;
  while (!text.empty()) {
    const std::string_view pair = text.substr(0, text.find('&'));
    const std::size_t equals = pair.find('=');
    query.emplace_back(pair.substr(0, equals),
                       equals == std::string_view::npos ? std::string_view{} : pair.substr(equals + 1));
    text.remove_prefix(std::min(pair.size() + 1, text.size()));
  }
  return query;
}

/// The text before the next @p separator, which is taken away with it.
std::string_view take(std::string_view& text, char separator) {
  const std::string_view part = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(part.size() + 1, text.size()));
  return part;
}

}  // namespace

std::string read_control(Input input) {
  static AskedUnit unit;
  std::string_view lines = text_of(input);
  while (!lines.empty())
    if (std::string broken = unit.rule_of(take(lines, '\n')); !broken.empty()) return broken;
  return "";
}

/// VERB PATH?QUERY, and a body in the lines behind that.
std::string read_http(Input input) {
  std::string_view text = text_of(input);
  std::string_view line = take(text, '\n');
  const std::string_view verb = take(line, ' ');
  const std::string_view path = take(line, '?');
  static_cast<void>(gateway::verbs_of(path));
  const auto match = gateway::find_route(verb, path);
  if (!match) return message_rule(match.error().message);
  const auto arguments = gateway::arguments_of(*match, query_in(line), text);
  if (!arguments) return message_rule(arguments.error().message);
  return arguments->is_object() ? "" : "parameters that are no object";
}

std::vector<std::string> made_control() {
  std::vector<std::string> lines;
  for (const control::Method& method : control::kMethods) {
    if (method.name == "units") continue;
    nlohmann::json params = nlohmann::json::object();
    for (const control::Parameter& parameter : method.parameters) params[std::string{parameter.key}] = 1;
    lines.push_back(control::request_line(1, method.name, params));
  }
  lines.push_back(R"({"id":1,"method":"parameter.read","params":{"axis":1,"parameters":["p0304","r0063"]}})");
  lines.push_back(R"({"id":1,"method":"parameter.write","params":{"axis":1,"parameter":"p1120","value":2.5}})");
  lines.push_back(R"({"id":1,"method":"object.read","params":{"index":"1018","sub_index":1}})");
  lines.push_back(R"({"id":1,"method":"inject.add","params":{"kind":"sdo.late","delay_ms":5}})");
  return lines;
}

std::vector<std::string> made_http() {
  std::vector<std::string> requests;
  for (const std::string_view path :
       {"", "/parameters/p1120?axis=2", "/explain?axis=1", "/pdos?all=true&count=5", "/axes/1/load"})
    for (const std::string_view verb : {"GET", "PUT", "POST", "DELETE", "OPTIONS"})
      requests.push_back(fmt::format("{} /api/v1/units/vcan0/5{}\n{{\"value\": 2.5}}", verb, path));
  return requests;
}

}  // namespace fuzz
