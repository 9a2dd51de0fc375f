#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "tools/axisctl/client.hpp"

namespace axisctl {

/// One argument of a command.
struct Argument {
  std::string_view name;     ///< as in the usage line
  std::string_view summary;  ///< one line
  std::string_view key;      ///< of the parameter that it becomes, which the daemon's complaints begin with
  bool optional = false;     ///< only the last ones
};

/// Words of the command line, one for each Argument; an optional one that is missing is empty.
using Words = std::span<const std::string>;

/// A row of the command table.
struct Command {
  std::string_view group;  ///< first word of a command of two words, empty otherwise
  std::string_view name;
  std::string_view summary;
  std::span<const Argument> arguments;
  control::Method method;
  /// The parameters that @p words ask for, or in one line what is wrong with them.
  tl::expected<nlohmann::json, std::string> (*parameters)(Words words);
  /// Prints the result for people.
  void (*print)(std::ostream& out, const nlohmann::json& result);
};

/// Every command of the program, those of one group side by side.
[[nodiscard]] std::span<const Command> commands() noexcept;

/// @p message of the daemon with the name of the argument where it complains of the parameter.
[[nodiscard]] std::string in_words_of(const Command& command, const std::string& message);

/// Axis number that @p word means (@p first..), or in one line what is wrong with it.
[[nodiscard]] tl::expected<int, std::string> parse_axis(const std::string& word, int first);
/// For commands that the control unit knows too: it is axis 0.
inline constexpr int kControlUnit = 0;

/// Parameters of explain ([AXIS]).
tl::expected<nlohmann::json, std::string> explain_parameters(Words words);
/// Prints the result of explain, a reason a line, below its axis if all were asked for.
void print_explanation(std::ostream& out, const nlohmann::json& result);
/// Parameters of fault inject (AXIS NUMBER [VALUE]); NUMBER is 7860, F7860 or F07860, 1..65535.
tl::expected<nlohmann::json, std::string> fault_inject_parameters(Words words);
/// Parameters of fault ack (AXIS).
tl::expected<nlohmann::json, std::string> fault_ack_parameters(Words words);
/// Parameters of load (AXIS TORQUE in N·m [TYPE]); the daemon knows the types.
tl::expected<nlohmann::json, std::string> load_parameters(Words words);
/// Parameters of supply (VOLTAGE in V rms between lines).
tl::expected<nlohmann::json, std::string> supply_parameters(Words words);
/// Parameters of encoder (AXIS DEFECT); the daemon knows the defects.
tl::expected<nlohmann::json, std::string> encoder_parameters(Words words);
/// Parameters of input (INPUT on|off); the daemon knows the inputs.
tl::expected<nlohmann::json, std::string> input_parameters(Words words);
/// Prints the result of status as aligned lines.
void print_status(std::ostream& out, const nlohmann::json& result);

}  // namespace axisctl
