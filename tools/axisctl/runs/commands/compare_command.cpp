#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "text/number.hpp"
#include "tools/axisctl/commands/command.hpp"
#include "tools/axisctl/print/printable.hpp"
#include "tools/axisctl/runs/compare/comparison.hpp"
#include "tools/axisctl/runs/compare/report.hpp"
#include "tools/axisctl/runs/log/eds_file.hpp"

namespace axisctl {
namespace {

/// What the words of compare say.
struct CompareWish {
  std::string a{}, b{}, time{"ignore"}, eds{}, interface {};
  std::vector<std::string> identifiers{};
  std::size_t surroundings = 4;
};
constexpr double kMostSurroundings = 1000;

Expected<runs::CompareOptions> options_of(const CompareWish& wish) {
  runs::CompareOptions options{.surroundings = wish.surroundings};
  const auto time = runs::read_time_rule(wish.time);
  if (!time)
    return fail(ExitStatus::Usage, fmt::format("--time: expected {}, got \"{}\"", runs::kTimeRule, wish.time));
  options.time = *time;
  constexpr std::size_t kShort = 3;
  for (const std::string& word : wish.identifiers) {
    const auto identifier = text::integer<std::uint32_t>(word, 16);
    const bool is_long = word.size() > kShort;
    if (!identifier || *identifier > (is_long ? canopen::cob_id::kLong : canopen::cob_id::kBase))
      return fail(
          ExitStatus::Usage,
          fmt::format("--id: expected an identifier of up to 3 digits up to 7FF or of more up to 1FFFFFFF, "
                      "got \"{}\"",
                      word));
    options.identifiers.insert(is_long ? *identifier | canopen::cob_id::kExtended : *identifier);
  }
  return options;
}

Expected<void> compare_logs(const Settings& settings, const CompareWish& wish) {
  const auto options = options_of(wish);
  if (!options) return tl::unexpected{options.error()};
  const auto description = runs::read_eds(wish.eds, 1);
  if (!description) return tl::unexpected{description.error()};
  auto a = runs::LogReader::open(wish.a, wish.interface);
  if (!a) return tl::unexpected{a.error()};
  auto b = runs::LogReader::open(wish.b, wish.interface);
  if (!b) return tl::unexpected{b.error()};
  const auto compared = runs::compare(**a, **b, *options, *description);
  if (!compared) return tl::unexpected{compared.error()};
  for (const std::string& remark : compared->remarks) std::cerr << "axisctl: " << printable(remark) << '\n';
  if (compared->frames == 0 && !compared->difference)
    return fail(ExitStatus::Damaged, fmt::format("{} and {}: there is no frame to compare", wish.a, wish.b));
  if (settings.json) {
    const auto report = json_of(*compared, wish.a, wish.b);
    if (auto printed =
            print_line(printable(report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace)));
        !printed)
      return printed;
  } else {
    std::cout << text_of(*compared, wish.a, wish.b) << std::flush;
  }
  if (!compared->difference) return {};
  return fail(ExitStatus::Failed, fmt::format("{} and {} differ", wish.a, wish.b));
}

}  // namespace

void add_compare(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "compare", "Show the first difference of two logs or recordings");
  const auto wish = std::make_shared<CompareWish>();
  sub.add_option("A", wish->a, "Log of candump, or recording")->required()->type_name("");
  sub.add_option("B", wish->b, "Another one")->required()->type_name("");
  sub.add_option("--time", wish->time,
                 "How times since the first frame are compared: exact, ignore (if not given), or by how much they "
                 "may differ, 500us, 2ms or 0.1s")
      ->type_name("RULE");
  sub.add_option("--id", wish->identifiers, "Only frames of this identifier, in hexadecimal; several times")
      ->allow_extra_args(false)
      ->type_name("ID");
  sub.add_option("--of", wish->interface, "Frames of this interface, if a log has several")->type_name("NAME");
  sub.add_option("--eds", wish->eds, "EDS for names of objects")->type_name("FILE");
  sub.add_option("--context", wish->surroundings, "Frames shown before and after, 4 if not given")
      ->check(CLI::Range(0.0, kMostSurroundings))
      ->type_name("N");
  sub.callback([&run, wish] { run = [wish](const Settings& settings) { return compare_logs(settings, *wish); }; });
}

}  // namespace axisctl
