#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "record/show.hpp"
#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/print/printable.hpp"

namespace axisctl {
namespace {

/// Prints the recording at @p path; what is to be said of its end goes to standard error.
Expected<void> show(const std::string& path, record::Form form) {
  const auto remark =
      record::show(path, form, [](std::string_view line) { std::cout << printable(line) << '\n'; });
  if (!remark) return fail(ExitStatus::NotThere, remark.error());
  std::cout.flush();
  if (!remark->empty()) std::cerr << "axisctl: " << printable(*remark) << '\n';
  return {};
}

}  // namespace

void add_record(CLI::App& app, Run& run) {
  CLI::App& group = subcommand(app, "record", "Record frames, writes and events into a file");
  group.require_subcommand(1);
  const auto path = std::make_shared<std::string>();
  CLI::App& shown = subcommand(group, "show", "Print the records of a recording, one a line");
  shown.add_option("FILE", *path, "Recording")->required()->type_name("");
  shown.callback([&run, path] {
    run = [path](const Settings& settings) {
      return show(*path, settings.json ? record::Form::Json : record::Form::Text);
    };
  });
  CLI::App& frames = subcommand(group, "candump", "Print the frames of a recording as candump -l does");
  frames.add_option("FILE", *path, "Recording")->required()->type_name("");
  frames.callback([&run, path] { run = [path](const Settings&) { return show(*path, record::Form::Candump); }; });
}

}  // namespace axisctl
