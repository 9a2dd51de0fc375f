#include <functional>
#include <memory>

#include <CLI/CLI.hpp>

#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/fleet/fleet_commands.hpp"

namespace axisctl {
namespace {

/// What the words of a subcommand say.
struct Words {
  std::string unit{}, host{}, file{};
  std::vector<std::string> units{};
};
using Do = std::function<Expected<void>(const Settings& settings)>;

/// @p what of a farm.
Run in_farm(Do what) {
  return [what = std::move(what)](const Settings& settings) -> Expected<void> {
    if (settings.farm == nullptr) return fail(ExitStatus::Usage, "fleet: expected --farm URL, or AXISD_FARM");
    return what(settings);
  };
}

CLI::App& add(CLI::App& group, Run& run, std::string_view name, std::string_view summary, const Do& what) {
  CLI::App& sub = subcommand(group, name, summary);
  sub.callback([&run, what] { run = in_farm(what); });
  return sub;
}

void add_word(CLI::App& sub, const char* name, std::string& word, const char* help) {
  sub.add_option(name, word, help)->required()->type_name("");
}

void add_apply(CLI::App& group, Run& run) {
  const auto wish = std::make_shared<fleet::ApplyWish>();
  CLI::App& sub = add(group, run, "apply", "Have units and buses wanted as files say",
                      [wish](const Settings& settings) { return fleet::run_apply(settings, *wish); });
  sub.add_option("FILE", wish->files, "Fleet files")->required()->type_name("");
  sub.add_flag("--unchecked", wish->unchecked, "Do not have axisd look at the configurations");
}

void add_state(CLI::App& group, Run& run) {
  CLI::App& state = subcommand(group, "state", "What units have saved, as the farm keeps it");
  state.require_subcommand(1);
  const auto words = std::make_shared<Words>();
  CLI::App& out =
      add(state, run, "export", "Write what a unit has saved to a file",
          [words](const Settings& settings) { return fleet::run_export(settings, words->unit, words->file); });
  CLI::App& in =
      add(state, run, "import", "Have a unit begin with what a file has, when it is started elsewhere",
          [words](const Settings& settings) { return fleet::run_import(settings, words->unit, words->file); });
  for (CLI::App* const sub : {&out, &in}) {
    add_word(*sub, "UNIT", words->unit, "BUS/NODE");
    add_word(*sub, "FILE", words->file, "File");
  }
}

}  // namespace

void add_fleet(CLI::App& app, Run& run) {
  CLI::App& group = subcommand(app, "fleet", "Units that are wanted in a farm, and hosts that run them");
  group.require_subcommand(1);
  add_apply(group, run);
  add(group, run, "list", "Show which units are wanted, where they are, and how they do", fleet::run_list);
  add(group, run, "hosts", "Show the hosts that run units", fleet::run_hosts);
  const auto words = std::make_shared<Words>();
  CLI::App& remove = add(group, run, "remove", "Have units wanted no more",
                         [words](const Settings& settings) { return fleet::run_remove(settings, words->units); });
  remove.add_option("UNIT", words->units, "BUS/NODE, or BUS/* for all units of a bus")->required()->type_name("");
  CLI::App& move = add(group, run, "move", "Have a unit wanted on one host", [words](const Settings& settings) {
    return fleet::run_move(settings, words->unit, words->host);
  });
  add_word(move, "UNIT", words->unit, "BUS/NODE");
  CLI::App& drain = add(group, run, "drain", "Have a host give its units away", [words](const Settings& settings) {
    return fleet::run_drain(settings, words->host, true);
  });
  CLI::App& undrain =
      add(group, run, "undrain", "Have a host take units again",
          [words](const Settings& settings) { return fleet::run_drain(settings, words->host, false); });
  for (CLI::App* const sub : {&move, &drain, &undrain}) add_word(*sub, "HOST", words->host, "Name of the host");
  add_state(group, run);
}

}  // namespace axisctl
