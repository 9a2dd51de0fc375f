#include "tools/axisctl/runs/commands/yardstick_wish.hpp"

#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "can/userbus/bit_rate.hpp"
#include "os/regular_file.hpp"
#include "tools/axisctl/page/files.hpp"
#include "tools/axisctl/print/printable.hpp"
#include "tools/axisctl/runs/compare/comparison.hpp"
#include "tools/axisctl/runs/log/eds_file.hpp"
#include "tools/axisctl/runs/log/log_facts.hpp"

namespace axisctl {
namespace {

constexpr double kLastNode = 127;
constexpr double kMostShown = 100'000;
constexpr std::size_t kLargestList = std::size_t{1} << 20U;

/// The known differences at @p path; if it is empty, those of the installation.
Expected<runs::KnownDifferences> read_known(const std::string& path) {
  const std::string chosen = path.empty() ? installed("eds/axisd-twin.json").string() : path;
  const auto text = os::read_regular_file(chosen, kLargestList);
  if (!text && path.empty() && text.error().is_missing()) return runs::KnownDifferences{};
  if (!text)
    return fail(ExitStatus::NotThere, fmt::format("{}: cannot be read: {}", chosen, text.error().reason()));
  auto known = runs::KnownDifferences::parse(*text);
  if (!known) return fail(ExitStatus::Usage, fmt::format("{}: {}", chosen, known.error()));
  return *std::move(known);
}

Expected<runs::Yardstick> yardstick_of(const YardstickWish& wish) {
  runs::Yardstick yardstick;
  const auto time = runs::read_duration(wish.time);
  if (!time)
    return fail(ExitStatus::Usage, fmt::format("--time-band: expected a time as 20ms, got \"{}\"", wish.time));
  yardstick.time = *time;
  for (const std::string& band : wish.bands)
    if (!yardstick.bands.add(band))
      return fail(ExitStatus::Usage, fmt::format("--band: expected {}, got \"{}\"", runs::kBandRule, band));
  auto known = read_known(wish.deviations);
  if (!known) return tl::unexpected{known.error()};
  yardstick.known = *std::move(known);
  return yardstick;
}

}  // namespace

void add_yardstick(CLI::App& sub, YardstickWish& wish) {
  sub.add_option("LOG", wish.log, "Log of candump, or recording")->required()->type_name("");
  sub.add_option("--node", wish.node, "Node-ID of the unit, that of the log if one has answered there")
      ->check(CLI::Range(1.0, kLastNode))
      ->type_name("N");
  sub.add_option("--of", wish.interface, "Frames of this interface, if the log has several")->type_name("NAME");
  sub.add_option("--eds", wish.eds, "EDS of the unit: names, types, COB-IDs and mappings")->type_name("FILE");
  sub.add_option("--band", wish.bands,
                 "By how much an object may differ: 606Ch=100, or 2015h:00=2% of its largest value; several times")
      ->allow_extra_args(false)
      ->type_name("OBJECT=T");
  sub.add_option("--time-band", wish.time, "By how much times may differ, 20ms if not given")->type_name("T");
  sub.add_option("--deviations", wish.deviations, "Known differences, those of the installation if not given")
      ->type_name("FILE");
  sub.add_option("--bitrate", wish.bit_rate, "Bit rate of the bus (bit/s); a log that is too dense for it is told")
      ->check(CLI::Range(0.0, static_cast<double>(userbus::kHighestBitRate)))
      ->type_name("N");
  sub.add_option("--show", wish.most, "Differences that are shown, 20 if not given")
      ->check(CLI::Range(0.0, kMostShown))
      ->type_name("N");
}

Expected<PlayedLog> prepare(const YardstickWish& wish) {
  PlayedLog log;
  auto yardstick = yardstick_of(wish);
  if (!yardstick) return tl::unexpected{yardstick.error()};
  const auto facts = runs::check_log(wish.log, wish.interface, wish.bit_rate.value_or(0), log.remarks);
  if (!facts) return tl::unexpected{facts.error()};
  for (unsigned node = 1; node < facts->nodes().size(); ++node)
    if (wish.node ? *wish.node == node : facts->nodes().test(node))
      log.nodes.push_back(static_cast<std::uint8_t>(node));
  if (log.nodes.empty())
    return fail(ExitStatus::Usage,
                fmt::format("{}: no node has answered in it: --node says which unit is meant", wish.log));
  auto description = runs::read_eds(wish.eds, log.nodes.front());
  if (!description) return tl::unexpected{description.error()};
  log.yardstick = *std::move(yardstick);
  log.yardstick.description = *std::move(description);
  for (const std::string& remark : log.remarks) std::cerr << "axisctl: " << printable(remark) << '\n';
  return log;
}

Expected<void> print_report(const Settings& settings, const nlohmann::json& report, const std::string& text) {
  if (settings.json)
    return print_line(printable(report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
  std::cout << text << std::flush;
  return {};
}

}  // namespace axisctl
