#include <array>
#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "cli/completion.hpp"
#include "cli/exit_status.hpp"
#include "tools/edstool/command.hpp"
#include "version/version.hpp"

namespace {

constexpr std::array kExitRows{
    cli::ExitRow{edstool::kClean, "clean, or warnings only"},
    cli::ExitRow{edstool::kFound, "an error or a difference was found"},
    cli::ExitRow{edstool::kUsage, "wrong usage, or a file that cannot be read or written"},
};

int complain(std::string_view text) {
  std::cerr << "edstool: " << text << '\n';
  return edstool::kUsage;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Reads, checks and makes EDS and DCF files of CANopen devices.", "edstool"};
  edstool::Invocation invocation;
  app.set_version_flag("--version", version::line("edstool"));
  app.add_flag("--json", invocation.json, "Print the result as one line of JSON");
  app.footer(cli::exit_footer(kExitRows));
  for (const edstool::AddCommand add : edstool::commands()) add(app, invocation);
  cli::add_completion(app);
  app.require_subcommand(1);
  app.fallthrough();
  for (CLI::App* const command : app.get_subcommands({})) command->fallthrough();
  try {
    app.parse(argc, argv);
    const int status = invocation.run();
    std::cout.flush();
    return std::cout ? status : complain("standard output: cannot be written");
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    return complain(error.what());
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}
