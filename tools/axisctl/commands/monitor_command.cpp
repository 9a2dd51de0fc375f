#include <array>
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

struct Monitor {
  std::vector<std::string> kinds{};
  unsigned count = 0;  ///< events; 0: no end
};

/// Members that a line begins with, in this order; the others follow with their names.
constexpr std::array<const char*, 3> kFirst{"t", "unit", "kind"};

/// "   12.345678  vcan0/5  fault  axis 1, number 7860, text External fault 1".
std::string line_of(json event) {
  std::string line = fmt::format("{:>12.6f}", event.value("t", 0.0));
  for (const char* const key : kFirst)
    if (event.contains(key) && key != kFirst.front()) line += "  " + text_of(event[key]);
  for (const char* const key : kFirst) event.erase(key);
  return event.empty() ? line : line + "  " + text_of(event);
}

Expected<void> run_monitor(const Settings& settings, const Monitor& monitor) {
  auto session = Session::open_to_all(settings);
  if (!session) return tl::unexpected{session.error()};
  json params = json::object();
  if (!monitor.kinds.empty()) params["kinds"] = monitor.kinds;
  const auto begun = session->ask("events.subscribe", params);
  if (!begun) return tl::unexpected{begun.error()};
  for (unsigned lines = 0; monitor.count == 0 || lines < monitor.count;) {
    const auto notice = session->client().next_notice();
    if (!notice) return tl::unexpected{notice.error()};
    if (!*notice) return fail(ExitStatus::CutOff, "the daemon closed the connection");
    if (!(*notice)->contains("event")) continue;
    const json event = printable_values((**notice)["event"]);
    ++lines;
    if (const auto printed = print_line(settings.json ? event.dump() : line_of(event)); !printed) return printed;
  }
  return {};
}

}  // namespace

void add_monitor(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "monitor", "Show events as they come");
  const auto monitor = std::make_shared<Monitor>();
  sub.add_option("KIND", monitor->kinds, "Kinds of events, all if not given")->type_name("");
  sub.add_option("--count", monitor->count, "Events, no end if not given")->type_name("N");
  sub.callback(
      [&run, monitor] { run = [monitor](const Settings& settings) { return run_monitor(settings, *monitor); }; });
}

}  // namespace axisctl
