#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "can/port/address.hpp"
#include "can/userbus/time.hpp"
#include "os/regular_file.hpp"
#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/page/files.hpp"
#include "tools/axisctl/print/printable.hpp"
#include "tools/axisctl/print/table.hpp"
#include "tools/axisctl/scenario/language/schema.hpp"
#include "tools/axisctl/scenario/report/report.hpp"
#include "tools/axisctl/scenario/run/bench.hpp"
#include "tools/axisctl/scenario/run/stations.hpp"

namespace axisctl {
namespace {

using nlohmann::json;
using scenario::Ran;

constexpr std::size_t kLargestFile = std::size_t{4} << 20U;
constexpr double kLargestSeed = 9007199254740991.0;

/// What the words of run say. A program of an option of CLI11 fills it.
struct RunWish {
  std::vector<std::string> files{};
  std::string bus{};
  std::string time{};
  std::string junit{};
  std::optional<std::uint64_t> seed{};
  std::string html{}, blank{};
  bool list = false, schema = false, check = false, keep = false, html_all = false;
};

/// Where the scenarios of an installation are.
std::filesystem::path installed_folder() {
  return installed("scenarios");
}

/// A file, or one of the installation by its name.
std::string path_of(const std::string& word) {
  std::error_code ignored;
  if (word.find('/') != std::string::npos || std::filesystem::exists(word, ignored)) return word;
  const std::filesystem::path installed = installed_folder() / (word + ".json");
  return std::filesystem::exists(installed, ignored) ? installed.string() : word;
}

/// Pages of scenarios in the folder that is wished for.
class Pages {
 public:
  /// Makes the folder, and reads the page to fill in; without a folder there are no pages.
  static Expected<Pages> open(const RunWish& wish) {
    Pages pages{wish};
    if (wish.html.empty()) return pages;
    auto blank = read_template(wish.blank);
    if (!blank) return tl::unexpected{blank.error()};
    pages.blank_ = *std::move(blank);
    std::error_code error;
    std::filesystem::create_directories(wish.html, error);
    if (error) return fail(ExitStatus::Failed, fmt::format("{}: {}", wish.html, error.message()));
    return pages;
  }
  [[nodiscard]] scenario::Captured captured() const noexcept {
    if (folder_.empty()) return scenario::Captured::None;
    return is_all_ ? scenario::Captured::All : scenario::Captured::Failed;
  }
  /// Writes that of @p ran, if there is to be one. Scenarios of the same name get numbers.
  Expected<void> write(Ran& ran) {
    if (!ran.result.is_captured) return {};
    const unsigned count = ++names_[ran.scenario.name];
    const std::string name = count == 1 ? ran.scenario.name : fmt::format("{}-{}", ran.scenario.name, count);
    const std::string path = fmt::format("{}/{}.html", folder_, name);
    if (auto written = write_page(path, blank_, page_of(ran.scenario, ran.result)); !written) return written;
    std::cerr << "axisctl: " << printable(path) << " shows what has happened\n";
    return {};
  }

 private:
  explicit Pages(const RunWish& wish) : folder_{wish.html}, is_all_{wish.html_all} {}

  std::string folder_, blank_{};
  bool is_all_ = false;
  std::map<std::string, unsigned> names_{};
};

Expected<scenario::Scenario> read(const std::string& word, const RunWish& wish) {
  const std::string path = path_of(word);
  const auto text = os::read_regular_file(path, kLargestFile);
  if (!text) {
    const ExitStatus status = text.error().is_missing() ? ExitStatus::NotThere : ExitStatus::Failed;
    const bool is_name = path == word && word.find('/') == std::string::npos;
    return fail(status, fmt::format("{}: cannot be read: {}{}", path, text.error().reason(),
                                    is_name ? "; axisctl run --list shows the installed scenarios" : ""));
  }
  auto read = scenario::read_scenario(*text, path, wish.seed);
  if (!read) return fail(ExitStatus::Usage, read.error());
  return *std::move(read);
}

Expected<void> list_installed(const Settings& settings) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator{installed_folder(), error})
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  if (error)
    return fail(ExitStatus::NotThere, fmt::format("{}: {}", installed_folder().string(), error.message()));
  std::ranges::sort(files);
  json all = json::array();
  Table table{{"scenario", "title"}};
  for (const auto& file : files) {
    const auto scenario = read(file.string(), {});
    if (!scenario) return tl::unexpected{scenario.error()};
    all.push_back({{"scenario", scenario->name},
                   {"title", scenario->title},
                   {"about", scenario->about},
                   {"references", scenario->references},
                   {"file", scenario->file}});
    table.add({scenario->name, scenario->title});
  }
  if (settings.json) return print_line(json{{"scenarios", all}}.dump());
  table.print(std::cout, !settings.style.brief);
  return {};
}

Expected<void> write_junit(const std::string& path, const std::vector<Ran>& runs) {
  if (path.empty()) return {};
  std::ofstream file{path};
  file << scenario::junit_of(runs) << std::flush;
  if (file) return {};
  return fail(ExitStatus::Failed, path + ": cannot be written");
}

/// All reports as JSON, or the end of those for people.
Expected<void> conclude(const Settings& settings, const RunWish& wish, const std::vector<Ran>& runs) {
  if (settings.json) {
    json reports = json::array();
    for (const auto& [scenario, result] : runs) reports.push_back(json_of(scenario, result));
    const std::string line = json{{"scenarios", reports}}.dump(-1, ' ', false, json::error_handler_t::replace);
    if (auto printed = print_line(printable(line)); !printed) return printed;
  }
  if (auto written = write_junit(wish.junit, runs); !written) return written;
  const auto failed = std::ranges::count_if(runs, [](const Ran& ran) { return !ran.result.passed; });
  if (failed == 0) return {};
  const Ran& last = runs.back();
  if (last.result.bad_input)
    return fail(ExitStatus::Usage, fmt::format("{}: {}", last.scenario.file, last.result.problem));
  if (last.result.interrupted) return fail(ExitStatus::Failed, "interrupted");
  return fail(ExitStatus::NotFulfilled, fmt::format("{} of {} scenarios failed", failed, runs.size()));
}

/// What the words say of the bus of the runs.
Expected<scenario::RunOptions> options_of(const RunWish& wish) {
  scenario::RunOptions options{.keep = wish.keep};
  if (!wish.bus.empty()) {
    const auto address = bus::parse_address(wish.bus);
    if (!address)
      return fail(ExitStatus::Usage, fmt::format("--bus: expected {}, got \"{}\"", address.error(), wish.bus));
    options.bus = wish.bus;
  }
  userbus::TimeWish time{};
  if (!wish.time.empty() && !userbus::read_time(wish.time.data(), wish.time.size(), time))
    return fail(ExitStatus::Usage, fmt::format("--time: expected {}, got \"{}\"", userbus::kTimeRule, wish.time));
  if (time.mode == userbus::TimeMode::Stepped)
    return fail(ExitStatus::Usage, "--time: a run steps nobody: real, scaled=K or virtual");
  if (time.mode != userbus::TimeMode::Real) options.time = wish.time;
  return options;
}

/// Every file is checked before anything starts.
Expected<std::vector<Ran>> read_all(const RunWish& wish) {
  std::vector<Ran> runs;
  for (const std::string& file : wish.files) {
    auto scenario = read(file, wish);
    if (!scenario) return tl::unexpected{scenario.error()};
    runs.push_back({.scenario = *std::move(scenario), .result = {}});
  }
  return runs;
}

Expected<void> run_scenarios(const Settings& settings, const RunWish& wish) {
  if (wish.schema) return print_line(scenario::schema().dump(2));
  if (wish.list) return list_installed(settings);
  if (!wish.check)
    if (auto done = expect_no_farm(settings, "run", "a scenario has units and a bus of its own, on this machine");
        !done)
      return done;
  if (wish.files.empty()) return fail(ExitStatus::Usage, "SCENARIO: expected a file or a name; see --list");
  auto options = options_of(wish);
  if (!options) return tl::unexpected{options.error()};
  auto runs = read_all(wish);
  if (!runs) return tl::unexpected{runs.error()};
  if (wish.check) return {};
  auto pages = Pages::open(wish);
  if (!pages) return tl::unexpected{pages.error()};
  options->captured = pages->captured();
  scenario::take_signals();
  Expected<void> pages_written{};
  std::size_t done = 0;
  for (Ran& ran : *runs) {
    ran.result = scenario::run(ran.scenario, *options);
    ++done;
    if (wish.keep) std::cerr << "axisctl: files are kept in " << ran.result.folder << '\n';
    if (!settings.json && !ran.result.bad_input) std::cout << text_of(ran.scenario, ran.result) << std::flush;
    if (auto written = pages->write(ran); !written) pages_written = written;
    if (ran.result.interrupted || ran.result.bad_input) break;
  }
  runs->resize(done);
  const auto concluded = conclude(settings, wish, *runs);
  return pages_written ? concluded : pages_written;
}

}  // namespace

void add_run(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "run", "Run scenarios: units on a bus of their own, steps, expectations");
  const auto wish = std::make_shared<RunWish>();
  sub.add_option("SCENARIO", wish->files, "Files, or names of installed scenarios")->type_name("");
  sub.add_flag("--list", wish->list, "List the installed scenarios");
  sub.add_flag("--schema", wish->schema, "Print the schema of scenarios (JSON Schema)");
  sub.add_flag("--check", wish->check, "Check the files, run nothing");
  sub.add_option("--seed", wish->seed, "Seed of all faults, over that of the file")
      ->check(CLI::Range(0.0, kLargestSeed))
      ->type_name("N");
  CLI::Option* const bus =
      sub.add_option("--bus", wish->bus, "Use a bus that is there: an interface or a URL, not a private one")
          ->type_name("IF");
  sub.add_option("--time", wish->time, "Whose time a private bus has: real (default), scaled=K or virtual")
      ->excludes(bus)
      ->type_name("TIME");
  sub.add_flag("--keep", wish->keep, "Keep the files of the run: configurations, logs, state");
  sub.add_option("--junit", wish->junit, "Write a JUnit report to FILE")->type_name("FILE");
  CLI::Option* const html =
      sub.add_option("--html", wish->html, "Write a page for a browser to DIR for each scenario that fails")
          ->type_name("DIR");
  sub.add_flag("--html-all", wish->html_all, "And for those that pass")->needs(html);
  sub.add_option("--template", wish->blank, "Page to fill in, that of the installation if not given")
      ->needs(html)
      ->type_name("FILE");
  sub.callback(
      [&run, wish] { run = [wish](const Settings& settings) { return run_scenarios(settings, *wish); }; });
}

}  // namespace axisctl
