#include <cmath>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/print/printable.hpp"

namespace axisctl {
namespace {

using nlohmann::json;

constexpr double kMillisecondsPerSecond = 1000.0;
constexpr int kWidth = 12;

struct Watch {
  std::vector<std::string> signals{};
  double every = 1.0;  ///< s
  unsigned count = 0;  ///< lines; 0: no end
};

/// Time and values in columns.
std::string line_of(const json& sample) {
  std::string line = fmt::format("{:>{}.3f}", sample.value("t", 0.0), kWidth);
  for (const json& value : sample.value("values", json::array()))
    line += value.is_number() ? fmt::format(" {:>{}.6g}", value.get<double>(), kWidth)
                              : fmt::format(" {:>{}}", text_of(value), kWidth);
  return line;
}

Expected<void> run_watch(const Settings& settings, const Watch& watch) {
  auto session = Session::open(settings);
  if (!session) return tl::unexpected{session.error()};
  const auto period = static_cast<int>(std::lround(watch.every * kMillisecondsPerSecond));
  const auto begun = session->ask("samples.subscribe", {{"signals", watch.signals}, {"period_ms", period}});
  if (!begun) return tl::unexpected{begun.error()};
  if (!settings.json && !settings.style.brief) {
    std::string head = fmt::format("{:>{}}", "s", kWidth);
    for (const std::string& signal : watch.signals) head += fmt::format(" {:>{}}", signal, kWidth);
    if (const auto printed = print_line(head); !printed) return printed;
  }
  for (unsigned lines = 0; watch.count == 0 || lines < watch.count;) {
    const auto notice = session->client().next_notice();
    if (!notice) return tl::unexpected{notice.error()};
    if (!*notice) return fail(ExitStatus::CutOff, "the daemon closed the connection");
    if (!(*notice)->contains("sample")) continue;
    const json sample = printable_values((**notice)["sample"]);
    ++lines;
    if (const auto printed = print_line(settings.json ? sample.dump() : line_of(sample)); !printed) return printed;
  }
  return {};
}

}  // namespace

void add_watch(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "watch", "Show values again and again");
  const auto watch = std::make_shared<Watch>();
  sub.add_option("SIGNAL", watch->signals, "Signals, as 1/speed, 1/r0063 or p1120")->required()->type_name("");
  sub.add_option("--every", watch->every, "Time between two lines (s), 1 if not given")
      ->check(CLI::PositiveNumber)
      ->type_name("S");
  sub.add_option("--count", watch->count, "Lines, no end if not given")->type_name("N");
  sub.callback([&run, watch] { run = [watch](const Settings& settings) { return run_watch(settings, *watch); }; });
}

}  // namespace axisctl
