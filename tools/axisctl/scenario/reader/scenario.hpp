#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "tools/axisctl/scenario/language/keys.hpp"

namespace scenario {

/// A drive unit that the scenario has.
struct UnitPlan {
  std::string name;
  std::uint8_t node_id = 1;
  nlohmann::json config{};  ///< as axisd reads it, with node-ID and faults
  bool on = true;
};

/// A program under test.
struct ProgramPlan {
  std::string name;
  std::vector<std::string> command{};
  std::optional<int> exit_status{};
  bool by_step = false;
};

/// Something to wait for: a row of conditions() and its keys.
struct Condition {
  const Alternative* row = nullptr;
  nlohmann::json keys{};
};

/// A step: a row of actions() and all its keys.
struct Step {
  std::size_t number = 1;
  const Alternative* action = nullptr;
  nlohmann::json keys{};
  std::string text{};  ///< what it is called in reports
};

/// A scenario that was checked from end to end.
struct Scenario {
  std::string file, name, title;
  std::vector<std::string> about{}, references{};
  std::uint64_t seed = 1;
  double limit_s = kUsualScenario;
  std::uint32_t bit_rate = 0;
  std::vector<nlohmann::json> bus_faults{};
  std::vector<UnitPlan> units{};
  std::vector<ProgramPlan> programs{};
  std::vector<Step> steps{};
};

/// Reads the scenario @p text of @p file, with @p seed over that of the file. The error is one line: file, path of
/// the key, what was expected.
[[nodiscard]] tl::expected<Scenario, std::string> read_scenario(std::string_view text, const std::string& file,
                                                                std::optional<std::uint64_t> seed = std::nullopt);

/// The condition at @p keys, which was checked.
[[nodiscard]] Condition condition_of(const nlohmann::json& keys);
/// The texts of Form::Texts.
[[nodiscard]] std::vector<std::string> texts_of(const nlohmann::json& value);

}  // namespace scenario
