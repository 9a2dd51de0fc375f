#include "tools/canrec/command_line.hpp"

#include <array>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "version/version.hpp"

namespace canrec {

namespace {

constexpr const char* kDescription =
    "Records a bus of several hosts on the NATS server that joins them, and plays recordings and logs of candump.";

constexpr int number(Status status) noexcept {
  return static_cast<int>(status);
}
constexpr std::array kExitRows{
    cli::ExitRow{number(Status::Done), "done"},
    cli::ExitRow{number(Status::Failed), "a file or standard output cannot be read or written"},
    cli::ExitRow{number(Status::Usage), "wrong usage"},
    cli::ExitRow{number(Status::NoServer),
                 "the server is not there, has no JetStream, does not answer or refuses"},
    cli::ExitRow{number(Status::NotThere),
                 "no such bus or recording, or there is a recording of that name already"},
    cli::ExitRow{number(Status::Damaged),
                 "import, play: a line of the log is damaged, or there is no frame in it"},
    cli::ExitRow{number(Status::NoBus), "play: the bus is not there or down, or takes nothing for 10 s"},
    cli::ExitRow{number(Status::BusDown), "play: the bus went down before the last frame"},
};

/// What is wrong, with the subcommands if it is one of them that is missing.
std::string complaint(const CLI::App& app, const CLI::ParseError& error) {
  if (!app.get_subcommands().empty() || dynamic_cast<const CLI::RequiredError*>(&error) == nullptr)
    return error.what();
  std::vector<std::string> names;
  for (const CLI::App* const sub : app.get_subcommands({})) names.push_back(sub->get_name());
  const std::vector<std::string> rest = app.remaining(true);
  return fmt::format("expected a subcommand: {}{}", fmt::join(names, ", "),
                     rest.empty() ? "" : fmt::format(", got \"{}\"", rest.front()));
}

}  // namespace

Invocation parse_command_line(int count, const char* const* words) {
  Invocation invocation;
  CLI::App app{kDescription, "canrec"};
  app.footer(cli::exit_footer(kExitRows));
  app.set_version_flag("--version", version::line("canrec"));
  nats::add_server_options(app, invocation.server);
  for (const AddCommand add : commands()) add(app, invocation.run);
  cli::add_completion(app);
  app.require_subcommand(1);
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw UsageError{complaint(app, error)};
    (void)app.exit(error);
    invocation.run = {};
  }
  return invocation;
}

}  // namespace canrec
