#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace control {

/// How the value of a parameter is written, in a request and as a word of a command line.
enum class Form : std::uint8_t {
  Axis,      ///< an integer from Range::low to the number of axes; 0 is the control unit
  Place,     ///< a drive object: 0 is the control unit, 1.. an axis, "infeed" the infeed
  Integer,   ///< an integer of the range
  Terminal,  ///< an integer of one of Parameter::terminals; the range goes from the lowest to the highest
  Fault,     ///< an integer of the range; as a word also F07860, A07850
  Number,    ///< a number of the range
  Choice,    ///< a text, one of Parameter::choices
  Switch,    ///< true or false; as a word on or off
  Text,      ///< a text
  List,      ///< texts, as many as the range says; one alone may stand for a list of one
  Words,  ///< words of 16 bits: integers or hexadecimal texts, as many as the range says, or one hexadecimal text
          ///< of all
  Value,  ///< what a parameter or object may be set to: a number or a text
  Hexadecimal,  ///< a number, or a text of hexadecimal digits, which a word is as it stands
  Any           ///< any JSON value, which the method itself looks at
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
  std::string_view unit{};                      ///< of a Number; empty where it has none
  std::span<const std::string_view> choices{};  ///< of a Choice
  std::span<const Range> terminals{};           ///< of a Terminal, ascending
  Exception exception{};                        ///< to the range of a Number
  std::string_view absent{};                    ///< what its absence means; empty: it is required
  std::string_view argument{};                  ///< its name on the command line
  std::string_view option{};                    ///< the option that it is there, without dashes; empty: a word
  std::string_view help{};                      ///< of that argument, one line
};

/// Who carries a method out.
enum class Scope : std::uint8_t {
  Unit,    ///< one unit; `unit` among the parameters says which
  Program  ///< the daemon, for all of its units
};

/// Whether a method changes something in the unit that no other event tells of, so that it is one itself.
enum class Acts : std::uint8_t {
  No,      ///< it looks, or its effect has events of its own
  Always,  ///< each time it succeeds
  Change   ///< when it has other parameters than the last time: it may be repeated to renew what it does
};

/// One method: what can be asked of a daemon over its control socket, and the subcommand of axisctl that asks it.
struct Method {
  std::string_view name;  ///< on the socket
  Scope scope = Scope::Unit;
  std::string_view group{};                     ///< first word of a subcommand of two words, empty otherwise
  std::string_view command{};                   ///< last word of the subcommand; empty: it has none of its own
  std::string_view summary{};                   ///< of the subcommand, one line
  std::span<const Parameter> parameters{};      ///< of the words, those that may be left out are the last ones
  std::span<const std::string_view> keys{};     ///< members of the result and below, in the order of its schema
  std::span<const std::string_view> columns{};  ///< what a table of the result shows; empty: all
  std::span<const std::string_view> brief{};    ///< the same where it is to be brief
  Acts acts = Acts::No;
  bool of_parameters = false;  ///< a device without parameters (profile cia402) refuses it
};

/// What the subcommands of a group have in common.
struct Group {
  std::string_view name;
  std::string_view summary;
};

}  // namespace control
