#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/page/files.hpp"
#include "tools/axisctl/page/resources.hpp"
#include "tools/axisctl/page/unit_recorder.hpp"
#include "tools/axisctl/print/printable.hpp"

namespace axisctl {
namespace {

using nlohmann::json;

constexpr double kUsualLength = 10.0, kLongest = 3600.0, kShortestPeriod = 0.001;

/// What the words of record say of a page.
struct PageWish {
  std::string html{}, title{}, blank{}, eds{};
  std::vector<std::string> from{}, signals{};
  double length_s = kUsualLength;
  std::optional<double> every_s{};
};

void remark(const std::string& text) {
  std::cerr << "axisctl: " << printable(text) << '\n';
}

Ask ask_of(Session& session) {
  return [&session](std::string_view method, json params) { return session.ask(method, std::move(params)); };
}

void add_snapshot(PageUnit& unit, const Ask& ask) {
  Snapshot snapshot = take_snapshot(ask);
  if (snapshot.cut_off) remark("the page has not all of the unit: " + snapshot.cut_off->message);
  unit.resources = std::move(snapshot.resources);
}

Expected<void> add_eds(PageUnit& unit, const std::string& path) {
  const std::size_t axes = unit.recordings.empty() ? 0 : unit.recordings.back().axes();
  const std::string profile = profile_of(unit);
  auto eds = read_eds(path, profile, axes);
  if (!eds) return tl::unexpected{eds.error()};
  if (eds->empty())
    remark(
        fmt::format("no EDS of a unit of profile {} with {} axes is installed: the page has none", profile, axes));
  unit.eds = *std::move(eds);
  return {};
}

/// Records the unit that is meant.
Expected<std::vector<PageUnit>> unit_of_bus(const Settings& settings, const PageWish& wish) {
  auto session = Session::open(settings);
  if (!session) return tl::unexpected{session.error()};
  const Ask ask = ask_of(*session);
  const std::chrono::duration<double> length{wish.length_s};
  const auto recorded = record_unit(ask, {.signals = wish.signals,
                                          .every_s = wish.every_s,
                                          .length = std::chrono::duration_cast<std::chrono::nanoseconds>(length)});
  if (!recorded) return tl::unexpected{recorded.error()};
  PageUnit unit;
  add_snapshot(unit, ask);
  const auto file = written_file(ask);
  if (!file) return tl::unexpected{file.error()};
  auto recordings = read_halves(*file);
  if (!recordings) return tl::unexpected{recordings.error()};
  unit.recordings = *std::move(recordings);
  unit.unit = unit.recordings.back().unit();
  return std::vector{std::move(unit)};
}

/// The unit of @p units that @p recording is of; a new one if there is none yet.
PageUnit& unit_for(std::vector<PageUnit>& units, const Recording& recording) {
  const std::string name = recording.unit();
  const auto found = std::ranges::find(units, name, &PageUnit::unit);
  return found != units.end() ? *found : units.emplace_back(PageUnit{.unit = name});
}

/// What the unit that is meant tells, if it is there and among @p units.
void add_what_is_there(const Settings& settings, std::vector<PageUnit>& units) {
  auto session = Session::open(settings);
  const auto status = session ? session->ask("status") : tl::unexpected{session.error()};
  if (!status) return;
  const std::string name = unit_name(status->value("interface", ""), std::to_string(status->value("node_id", 0)));
  const auto unit = std::ranges::find(units, name, &PageUnit::unit);
  if (unit != units.end()) add_snapshot(*unit, ask_of(*session));
}

Expected<std::vector<PageUnit>> units_of_files(const Settings& settings, const PageWish& wish) {
  std::vector<PageUnit> units;
  for (const std::string& path : wish.from) {
    auto recording = read_recording(path);
    if (!recording) return tl::unexpected{recording.error()};
    if (!recording->remark.empty()) remark(recording->remark);
    PageUnit& unit = unit_for(units, *recording);
    unit.recordings.push_back(*std::move(recording));
  }
  add_what_is_there(settings, units);
  return units;
}

Expected<void> run_page(const Settings& settings, const PageWish& wish) {
  if (wish.from.empty())
    if (auto done = expect_no_farm(settings, "record --html", "the recording is written on the host of the unit");
        !done)
      return done;
  if (auto folder = check_folder_of(wish.html); !folder) return folder;
  auto blank = read_template(wish.blank);
  if (!blank) return tl::unexpected{blank.error()};
  auto units = wish.from.empty() ? unit_of_bus(settings, wish) : units_of_files(settings, wish);
  if (!units) return tl::unexpected{units.error()};
  for (PageUnit& unit : *units)
    if (auto eds = add_eds(unit, wish.eds); !eds) return eds;
  Page page{.title = wish.title, .made_at = time_of_making(), .units = *std::move(units)};
  if (page.title.empty()) page.title = page.units.front().unit;
  return write_page(wish.html, *std::move(blank), page);
}

}  // namespace

void add_page(CLI::App& app, Run& run) {
  CLI::App& group = subcommand(app, "record", "Record frames, writes and events into a file");
  const auto wish = std::make_shared<PageWish>();
  CLI::Option* const html = group.add_option_function<std::string>(
      "--html",
      [&run, &group, wish](const std::string& path) {
        wish->html = path;
        group.require_subcommand(0);
        run = [wish](const Settings& settings) { return run_page(settings, *wish); };
      },
      "Record the unit, and write a page for a browser to FILE");
  html->type_name("FILE");
  for (CLI::App* const sub : group.get_subcommands({})) sub->excludes(html);
  const auto add = [&group, html](const std::string& name, auto& variable, const char* help, const char* type) {
    return group.add_option(name, variable, help)->needs(html)->type_name(type);
  };
  add("--from", wish->from, "Recordings to show instead", "FILE");
  add("--for", wish->length_s, "Length of the recording (s), 10 if not given; SIGINT ends it earlier", "S")
      ->check(CLI::Range(0.0, kLongest));
  add("--signals", wish->signals,
      "Signals to record; if not given speed, its setpoint, torque and current of axes", "SIGNAL")
      ->delimiter(',');
  add("--every", wish->every_s, "Period of their values (s), every cycle if not given", "S")
      ->check(CLI::Range(kShortestPeriod, kLongest));
  add("--title", wish->title, "Title of the page, the unit if not given", "TEXT");
  add("--eds", wish->eds, "EDS of the unit, that of the installation if not given", "FILE");
  add("--template", wish->blank, "Page to fill in, that of the installation if not given", "FILE");
}

}  // namespace axisctl
