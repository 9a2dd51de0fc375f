#pragma once

#include <functional>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/usage_error.hpp"
#include "eds/sheet/data_sheet.hpp"

namespace CLI {
class App;
}

namespace edstool {

/// Exit statuses.
inline constexpr int kClean = 0;
inline constexpr int kFound = 1;
inline constexpr int kUsage = 2;

using cli::UsageError;

/// What the command line asks for.
struct Invocation {
  bool json = false;
  std::function<int()> run;  ///< the chosen command; gives the exit status
};

/// Adds a subcommand with its options to the command line; it puts itself into the invocation when it is chosen.
using AddCommand = void (*)(CLI::App& app, Invocation& invocation);

/// Every subcommand.
[[nodiscard]] std::span<const AddCommand> commands() noexcept;

void add_lint(CLI::App& app, Invocation& invocation);
void add_show(CLI::App& app, Invocation& invocation);
void add_diff(CLI::App& app, Invocation& invocation);
void add_flatten(CLI::App& app, Invocation& invocation);
void add_dcf(CLI::App& app, Invocation& invocation);
void add_source(CLI::App& app, Invocation& invocation);

/// A file that was read, with what its values are not.
struct InputFile {
  /// UsageError where it cannot be read or has no section at all.
  explicit InputFile(const std::string& path);
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile() = default;

  std::string path;
  eds::Findings findings;  ///< bear the path as it was given
  eds::Document document;
  eds::DataSheet sheet;
};

/// The whole file at @p path; UsageError.
[[nodiscard]] std::string read_file(const std::string& path);

/// A finding as JSON.
[[nodiscard]] nlohmann::json to_json(const eds::Finding& finding);

/// What a command has made from a file.
struct Made {
  std::string text;
  eds::Findings findings;
  std::string output;  ///< path to write to; empty: standard output
};

/// Writes what was made, unless an error was found, and the findings to standard error; with @p json all of it as
/// JSON. Gives the exit status; UsageError where the file cannot be written.
int deliver(const Made& made, bool json);

}  // namespace edstool
