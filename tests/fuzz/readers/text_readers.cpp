// Texts that people write: what is refused is refused with one line that names the file.
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "daemon/configuration/base/configuration_error.hpp"
#include "daemon/configuration/configuration.hpp"
#include "injection/json/fault_json.hpp"
#include "injection/kinds/bus_kinds.hpp"
#include "injection/kinds/unit_kinds.hpp"
#include "sim/plan/world_plan.hpp"
#include "tests/fuzz/readers/readers.hpp"
#include "tools/axisctl/scenario/reader/scenario.hpp"

namespace fuzz {
namespace {

constexpr const char* kFile = "unit.json";
constexpr const char* kMotorFile = "./motor.json";
constexpr const char* kPreset = "1fk7063";

/// That of an axis of which no other one is said.
std::string usual_motor() {
  std::ifstream file{SOURCE_FOLDER "/motors/1fk7063.json"};
  return {std::istreambuf_iterator<char>{file}, {}};
}

/// One motor file, the usual one, and nothing else.
class OneMotor final : public axisd::MotorSource {
 public:
  explicit OneMotor(std::string_view text) : text_{text} {}

  std::string path_from(const std::string&, const std::string& name) const override { return name; }
  std::optional<std::string> find_preset(const std::string& name) const override {
    return name == kPreset ? std::optional<std::string>{kPreset} : std::nullopt;
  }
  std::set<std::string> presets() const override { return {kPreset}; }
  tl::expected<std::string, std::string> read(const std::string& path) const override {
    static const std::string kUsual = usual_motor();
    if (path == kPreset) return kUsual;
    if (path == kMotorFile) return text_.empty() ? kUsual : std::string{text_};
    return tl::unexpected{path + ": cannot be read: No such file or directory"};
  }

 private:
  std::string_view text_;
};

/// Of a configuration that is refused; empty: it is taken.
std::string refusal(std::string_view text, std::string_view motor) {
  try {
    static_cast<void>(axisd::parse_configuration(text, kFile, OneMotor{motor}));
    return "";
  } catch (const axisd::ConfigurationError& error) {
    return error.what();
  }
}

std::string names_a_file(std::string_view message, std::initializer_list<std::string_view> files) {
  for (const std::string_view file : files)
    if (message.starts_with(file)) return message_rule(message);
  return fmt::format("no file at the beginning of \"{}\"", message);
}

}  // namespace

bool takes_configuration(std::string_view text) {
  return refusal(text, "").empty();
}

std::string read_configuration(Input input) {
  const std::string message = refusal(text_of(input), "");
  return message.empty() ? "" : names_a_file(message, {kFile, kMotorFile});
}

std::string read_motor(Input input) {
  static const std::string kUnit = nlohmann::json{{"node_id", 1}, {"axes", {{{"motor", kMotorFile}}}}}.dump();
  const std::string message = refusal(kUnit, text_of(input));
  return message.empty() ? "" : names_a_file(message, {kFile, kMotorFile});
}

std::string read_scenario(Input input) {
  const auto read = scenario::read_scenario(text_of(input), kFile);
  return read ? "" : names_a_file(read.error(), {kFile});
}

/// What is taken is written as it is read.
std::string read_fault(Input input) {
  for (const std::span<const injection::Kind> kinds :
       {injection::unit_kinds(), std::span<const injection::Kind>{injection::bus_kinds()}}) {
    const auto fault = injection::read_fault_words(text_of(input), kinds);
    if (!fault) {
      if (std::string broken = message_rule(fault.error().message()); !broken.empty()) return broken;
      continue;
    }
    const nlohmann::json said = injection::json_of(*fault);
    const auto again = injection::read_fault(said, kinds);
    if (!again) return fmt::format("{} is not read again: {}", said.dump(), again.error().message());
    if (injection::json_of(*again) != said)
      return fmt::format("{} is {} when it is read again", said.dump(), injection::json_of(*again).dump());
  }
  return "";
}

std::string read_plan(Input input) {
  const auto plan = sim::read_plan(text_of(input));
  if (!plan) return message_rule(plan.error());
  const nlohmann::json said = sim::json_of(*plan);
  const auto again = sim::read_plan(said.dump());
  if (!again) return fmt::format("a plan is not read again: {}", again.error());
  return sim::json_of(*again) == said ? "" : "a plan is another one when it is read again";
}

std::vector<std::string> made_configurations() {
  return {
      R"({"node_id": 5, "axes": [{}]})",
      R"({"node_id": 3, "interface": "vcan1", "axes": [{"type": "vector", "motor": "./motor.json", "load": {"inertia": 0.01, "gear": [7, 3]}}]})",
      R"({"profile": "cia402", "node_id": 1, "axes": [{}, {"load": {"friction": {"coulomb": 0.1}, "torque": [1, {"type": "fan", "coefficient": 1e-4}]}}]})",
      R"({"threads": 2, "units": [{"node_id": 1, "axes": [{"parameters": {"p1120": 2.5}}]}, {"node_id": {"from": 2, "to": 9}, "axes": [{}, {}], "inject": [{"kind": "sdo.late", "delay_ms": 5}]}]})",
      R"({"node_id": 9, "axes": [{"positioner": true}], "trace": {"signals": ["1/r0063"], "samples": 100}, "record": {"name": "x"}, "modbus": {"port": 1502}})",
  };
}

std::vector<std::string> made_faults() {
  std::vector<std::string> words;
  for (const injection::Kind& kind : injection::unit_kinds())
    words.push_back(std::string{kind.name} + " after=1 every=2 times=3");
  for (const injection::Kind& kind : injection::bus_kinds())
    words.push_back(std::string{kind.name} + " id=185 until=10 heartbeat");
  return words;
}

std::vector<std::string> made_plans() {
  std::vector<std::string> plans;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) plans.push_back(sim::json_of(sim::draw_plan(seed)).dump());
  return plans;
}

}  // namespace fuzz
