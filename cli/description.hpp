#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace cli {

/// What a word of a command line may be.
enum class Kind : std::uint8_t {
  Nothing,    ///< whatever it is, no shell can know it
  Choices,    ///< one of Value::choices
  File,       ///< a path
  Folder,     ///< a path of a folder
  Interface,  ///< a network interface
  Unit,       ///< a unit that axisctl finds
  Command     ///< a command with its arguments, to the end of the line
};
struct Value {
  Kind kind = Kind::Nothing;
  std::vector<std::string> choices{};
};

/// An option.
struct Option {
  std::vector<std::string> names;  ///< with their dashes
  std::string help;
  bool takes_value = false;
  std::string argument{};  ///< name of the value
  Value value{};
};

/// A word that is no option.
struct Word {
  std::string name;
  std::string help{};
  bool required = false;
  bool repeats = false;  ///< and all behind it
  Value value{};
};

/// A program, or a subcommand. What it has as options, its subcommands have too.
struct Command {
  std::string name;
  std::string help;
  std::vector<Option> options{};
  std::vector<Word> words{};
  std::vector<Command> commands{};
  std::string footer{};  ///< what the help ends with
};

/// What @p app and its subcommands take; not what is hidden.
[[nodiscard]] Command describe(const CLI::App& app);

/// The value that a type name stands for: FILE, PATH and SOCKET, DIR, IF, UNIT.
[[nodiscard]] Value value_named(const std::string& type);

}  // namespace cli
