#include "tools/axisctl/scenario/reader/scenario.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "injection/language/random.hpp"
#include "json/strict.hpp"
#include "tools/axisctl/scenario/language/check.hpp"
#include "tools/axisctl/scenario/reader/references.hpp"

namespace scenario {
namespace {

using nlohmann::json;

/// Gives a seed of its own to each fault that has none: mixed of that of the scenario and the place in the file.
class Seeds {
 public:
  explicit Seeds(std::uint64_t seed) : seed_{seed} {}

  json give(json fault) {
    constexpr unsigned kSpare = 11;  // a JSON number holds 53 bits everywhere
    ++place_;
    if (!fault.contains("seed")) fault["seed"] = injection::Random{seed_ + place_}.next() >> kSpare;
    return fault;
  }

 private:
  std::uint64_t seed_, place_ = 0;
};

UnitPlan unit_of(const json& value, Seeds& seeds) {
  UnitPlan unit{
      .name = value.at("name"), .node_id = value.at("node_id"), .config = value.value("config", json::object())};
  unit.on = value.value("on", true);
  unit.config["node_id"] = unit.node_id;
  for (const json& fault : value.value("inject", json::array()))
    unit.config["inject"].push_back(seeds.give(fault));
  return unit;
}

ProgramPlan program_of(const json& value) {
  ProgramPlan program{.name = value.at("name"), .command = texts_of(value.at("command"))};
  if (value.contains("exit_status")) program.exit_status = value["exit_status"].get<int>();
  program.by_step = value.value("by_step", false);
  return program;
}

/// The keys of a step or condition as a sentence: "frame 585#80* count 2".
std::string sentence_of(const json& keys, const Alternative& row) {
  const auto text_of = [](const json& value) {
    return value.is_string() ? value.get<std::string>() : json_text::quote(value);
  };
  const json& value = keys.at(std::string{row.key.key});
  std::string text{row.key.key};
  if (row.key.form == Form::Condition || row.key.form == Form::State)
    text += " " + sentence_of(value, *alternative_of(value, conditions()));
  else if (row.key.form == Form::Fault)
    text += " " + value.at("kind").get<std::string>();
  else
    text += " " + text_of(value);
  for (const Key& key : row.beside)
    if (const auto found = keys.find(key.key); found != keys.end())
      text += fmt::format(" {} {}", key.key, text_of(*found));
  return text;
}

Step step_of(const json& value, std::size_t number, Seeds& seeds) {
  Step step{.number = number, .action = alternative_of(value, actions()), .keys = value};
  if (value.contains("inject")) step.keys["inject"] = seeds.give(value["inject"]);
  step.text = sentence_of(value, *step.action);
  return step;
}

}  // namespace

std::vector<std::string> texts_of(const json& value) {
  if (value.is_string()) return {value.get<std::string>()};
  return value.is_array() ? value.get<std::vector<std::string>>() : std::vector<std::string>{};
}

Condition condition_of(const json& keys) {
  return {.row = alternative_of(keys, conditions()), .keys = keys};
}

tl::expected<Scenario, std::string> read_scenario(std::string_view text, const std::string& file,
                                                  std::optional<std::uint64_t> seed) {
  const auto parsed = json_text::parse(text);
  if (!parsed) return tl::unexpected{file + ": " + parsed.error()};
  const json& value = *parsed;
  if (const auto mistake = find_mistake(value)) return tl::unexpected{file + ": " + *mistake};
  if (const auto mistake = find_wrong_name(value)) return tl::unexpected{file + ": " + *mistake};
  Scenario scenario{.file = file, .name = std::filesystem::path{file}.stem().string(), .title = value.at("title")};
  scenario.about = texts_of(value.value("about", json{}));
  scenario.references = texts_of(value.value("references", json{}));
  scenario.seed = seed.value_or(value.value("seed", std::uint64_t{1}));
  scenario.limit_s = value.value("limit_s", kUsualScenario);
  Seeds seeds{scenario.seed};
  const json bus = value.value("bus", json::object());
  scenario.bit_rate = bus.value("bit_rate", 0U);
  for (const json& fault : bus.value("inject", json::array())) scenario.bus_faults.push_back(seeds.give(fault));
  for (const json& unit : value.value("units", json::array())) scenario.units.push_back(unit_of(unit, seeds));
  for (const json& program : value.value("programs", json::array()))
    scenario.programs.push_back(program_of(program));
  for (const json& step : value.at("steps"))
    scenario.steps.push_back(step_of(step, scenario.steps.size() + 1, seeds));
  return scenario;
}

}  // namespace scenario
