#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace control {

/// How the value of a parameter is written, in a request and as a word of a command line.
enum class Form : std::uint8_t {
  Axis,      ///< an integer from Range::low to the number of axes; 0 is the control unit
  Integer,   ///< an integer of the range
  Terminal,  ///< an integer of one of Parameter::terminals; the range goes from the lowest to the highest
  Fault,     ///< an integer of the range; as a word also F07860, A07850
  Number,    ///< a number of the range
  Choice,    ///< a text, one of Parameter::choices
  Switch     ///< true or false; as a word on or off
};

/// From `low` to `high`, both included.
struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// Another range where parameter `key`, a Choice, is `choice`.
struct Exception {
  std::string_view key;  ///< empty: none
  std::string_view choice;
  Range range;
};

/// One parameter of a method.
struct Parameter {
  std::string_view key;  ///< in the request
  Form form = Form::Integer;
  Range range{};
  std::string_view unit{};                      ///< of a Number
  std::span<const std::string_view> choices{};  ///< of a Choice
  std::span<const Range> terminals{};           ///< of a Terminal, ascending
  Exception exception{};                        ///< to the range of a Number
  std::string_view absent{};                    ///< what its absence means; empty: it is required
  std::string_view meaning{};                   ///< for docs/control.md, beyond key and range
  std::string_view argument{};                  ///< its name on the command line
  std::string_view help{};                      ///< of that argument, one line
};

/// One method: what can be asked of a daemon over its control socket, and the subcommand of axisctl that asks it.
struct Method {
  std::string_view name;                  ///< on the socket
  std::string_view group;                 ///< first word of a subcommand of two words, empty otherwise
  std::string_view command;               ///< last word of the subcommand
  std::string_view summary;               ///< of the subcommand, one line
  std::span<const Parameter> parameters;  ///< those that may be left out are the last ones
  std::string_view result = "`{}`";       ///< for docs/control.md
};

/// What the subcommands of a group have in common.
struct Group {
  std::string_view name;
  std::string_view summary;
};

}  // namespace control
