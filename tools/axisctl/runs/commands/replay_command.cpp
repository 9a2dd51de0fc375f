#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "can/clock/time_share.hpp"
#include "os/clock.hpp"
#include "record/candump.hpp"
#include "tools/axisctl/page/files.hpp"
#include "tools/axisctl/runs/commands/yardstick_wish.hpp"
#include "tools/axisctl/runs/fidelity/judge.hpp"
#include "tools/axisctl/runs/fidelity/report.hpp"
#include "tools/canopen-check/port_wire.hpp"

namespace axisctl {
namespace {

/// What the words of replay say.
struct ReplayWish {
  YardstickWish common{};
  std::string bus{}, record{};
  double speed = 1.0, patience_s = 1.0;
  bool compares = false;
};
constexpr double kSlowest = 0.001, kFastest = 1'000'000, kShortestPatience = 0.001, kLongestPatience = 3600;

/// What has passed, as a log of candump.
std::string log_of(const runs::Course& course, std::chrono::nanoseconds begin) {
  std::string text;
  for (const runs::Passage& passage : course.passages)
    text += record::candump_line(passage.frame, begin + passage.at, "can0");
  return text;
}

runs::ReplayOptions replay_options(const ReplayWish& wish) {
  runs::ReplayOptions options{.speed = wish.speed};
  options.patience = std::chrono::duration_cast<canopen::Duration>(std::chrono::duration<double>{wish.patience_s});
  options.keeps_courses = wish.compares || !wish.record.empty();
  return options;
}

/// Says what has come of @p replay.
Expected<void> conclude(const Settings& settings, const ReplayWish& wish, const PlayedLog& log,
                        runs::Replay& replay) {
  nlohmann::json report{{"log", wish.common.log}, {"replay", json_of(replay.figures())}, {"remarks", log.remarks}};
  std::string text = text_of(replay.figures()) + '\n';
  std::uint64_t unknown = 0;
  if (wish.compares) {
    const runs::Fidelity fidelity = runs::judge(replay.log(), replay.run(), log.yardstick);
    report["fidelity"] = json_of(fidelity);
    text += text_of(fidelity, wish.common.most);
    unknown = fidelity.unknown();
  }
  if (auto printed = print_report(settings, report, text); !printed) return printed;
  if (unknown == 0) return {};
  return fail(ExitStatus::Failed, fmt::format("{} differences from {}", unknown, wish.common.log));
}

Expected<void> replay_log(const Settings& settings, const ReplayWish& wish) {
  if (auto done = expect_no_farm(settings, "replay", "it is a member of a bus of this machine"); !done)
    return done;
  const std::string name = wish.bus.empty() ? settings.interface : wish.bus;
  if (name.empty()) return fail(ExitStatus::Usage, "--bus: expected the bus of the unit, an interface or a URL");
  const auto address = bus::parse_address(name);
  if (!address)
    return fail(ExitStatus::Usage, fmt::format("--bus: expected {}, got \"{}\"", address.error(), name));
  auto log = prepare(wish.common);
  if (!log) return tl::unexpected{log.error()};
  log->yardstick.speed = wish.speed;
  runs::Nodes nodes;
  for (const std::uint8_t node : log->nodes) nodes.set(node);
  auto frames = runs::LogReader::open(wish.common.log, wish.common.interface);
  if (!frames) return tl::unexpected{frames.error()};
  conformance::take_signals();
  try {
    const auto time = bus::TimeShare::join(*address, 0);
    if (time) os::use_time(*time);
    conformance::PortWire wire{*address, time.get(), conformance::SignalEnds::WaitsAtOnce};
    const std::chrono::nanoseconds begin = os::wall_time();
    runs::Replay replay{wire, nodes, meaning::CobIds{log->yardstick.description}, replay_options(wish)};
    if (auto played = replay.play(**frames); !played) return played;
    if (!wish.record.empty())
      if (auto written = write_whole(wish.record, log_of(replay.run(), begin)); !written) return written;
    return conclude(settings, wish, *log, replay);
  } catch (const bus::OpenError& error) {
    return fail(ExitStatus::NotReachable, error.what());
  }
}

}  // namespace

void add_replay(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "replay", "Play the master's side of a log to a unit");
  const auto wish = std::make_shared<ReplayWish>();
  add_yardstick(sub, wish->common);
  sub.add_option("--bus", wish->bus, "Bus of the unit, an interface or a URL; as --interface")->type_name("IF");
  sub.add_option("--speed", wish->speed, "So many times as fast as it was")
      ->check(CLI::Range(kSlowest, kFastest))
      ->type_name("X");
  sub.add_option("--patience", wish->patience_s, "How long an answer of the log is waited for (s), 1 if not given")
      ->check(CLI::Range(kShortestPatience, kLongestPatience))
      ->type_name("S");
  sub.add_flag("--compare", wish->compares, "Compare what the unit answers with the log");
  sub.add_option("--record", wish->record, "Write what passes to FILE, as candump does")->type_name("FILE");
  sub.callback([&run, wish] { run = [wish](const Settings& settings) { return replay_log(settings, *wish); }; });
}

}  // namespace axisctl
