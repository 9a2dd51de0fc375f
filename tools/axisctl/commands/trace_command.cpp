#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/axisctl/commands/command.hpp"
#include "trace/export/result_reader.hpp"
#include "trace/export/svg_export.hpp"
#include "trace/export/text_export.hpp"

namespace axisctl {
namespace {

using nlohmann::json;

/// A format of a result, and the ending of its files.
struct Format {
  std::string_view ending;
  std::string (*text)(const trace::Result& result);
};
constexpr std::array kFormats{Format{".csv", trace::export_csv}, Format{".json", trace::export_json},
                              Format{".svg", trace::export_svg}};

struct Reading {
  std::string output{};  ///< empty: standard output, as CSV
  std::optional<std::uint64_t> result{};
};

Expected<const Format*> format_of(const Reading& reading, bool json_wanted) {
  if (reading.output.empty()) return &kFormats[json_wanted ? 1 : 0];
  const auto* const row = std::ranges::find_if(
      kFormats, [&](const Format& format) { return reading.output.ends_with(format.ending); });
  if (row != kFormats.end()) return row;
  return fail(
      ExitStatus::Usage,
      fmt::format("--output: expected a name that ends in .csv, .json or .svg, got \"{}\"", reading.output));
}

Expected<trace::Result> read_result(Session& session, const Reading& reading) {
  trace::ResultReader reader{reading.result};
  while (const auto params = reader.next()) {
    const auto page = session.ask("trace.read", *params);
    if (!page) return tl::unexpected{page.error()};
    if (const auto taken = reader.take(*page); !taken) return fail(ExitStatus::NotUnderstood, taken.error());
  }
  return std::move(reader).result();
}

Expected<void> run_read(const Settings& settings, const Reading& reading) {
  const auto format = format_of(reading, settings.json);
  if (!format) return tl::unexpected{format.error()};
  auto session = Session::open(settings);
  if (!session) return tl::unexpected{session.error()};
  const auto result = read_result(*session, reading);
  if (!result) return tl::unexpected{result.error()};
  const std::string text = (*format)->text(*result);
  if (reading.output.empty()) {
    std::cout << text << (text.ends_with('\n') ? "" : "\n");
    return {};
  }
  std::ofstream file{reading.output, std::ios::binary | std::ios::trunc};
  if ((file << text).flush()) return {};
  return fail(ExitStatus::Failed, reading.output + ": cannot be written");
}

}  // namespace

void add_trace(CLI::App& app, Run& run) {
  CLI::App& group = subcommand(app, "trace", "Record signals of a unit");
  CLI::App& sub = subcommand(group, "read", "Write a result of a trace as a table, JSON or a picture");
  const auto reading = std::make_shared<Reading>();
  sub.add_option("-o,--output", reading->output,
                 "FILE.csv, FILE.json or FILE.svg; CSV to standard output if not given")
      ->type_name("FILE");
  sub.add_option("--result", reading->result, "Number of the result, the latest if not given")->type_name("N");
  sub.callback(
      [&run, reading] { run = [reading](const Settings& settings) { return run_read(settings, *reading); }; });
}

}  // namespace axisctl
