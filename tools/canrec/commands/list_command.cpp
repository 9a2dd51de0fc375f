#include <algorithm>
#include <array>
#include <ctime>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/canrec/commands/command.hpp"
#include "tools/canrec/server/store.hpp"

namespace canrec {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 3> kStates{"running", "stuck", "stopped"};

std::string_view name_of(Recording::State state) noexcept {
  return kStates[static_cast<std::size_t>(state)];
}

/// "2026-11-25 20:10:39.800Z".
std::string date_of(std::chrono::nanoseconds time) {
  const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(time);
  const auto seconds = std::chrono::floor<std::chrono::seconds>(milliseconds);
  return fmt::format("{:%F %T}.{:03}Z", fmt::gmtime(static_cast<std::time_t>(seconds.count())),
                     (milliseconds - seconds).count());
}

double seconds(std::chrono::nanoseconds time) noexcept {
  return std::chrono::duration<double>{time}.count();
}

json row_of(const Recording& recording) {
  json row{{"name", recording.name},
           {recording.is_of_log ? "log" : "bus", recording.bus},
           {"state", name_of(recording.state)},
           {"messages", recording.messages},
           {"bytes", recording.bytes}};
  if (recording.messages == 0) return row;
  row["from"] = seconds(recording.from);
  row["to"] = seconds(recording.to);
  return row;
}

void print_json(const std::vector<Recording>& recordings) {
  json rows = json::array();
  for (const Recording& recording : recordings) rows.push_back(row_of(recording));
  std::cout << json{{"recordings", rows}}.dump(-1, ' ', false, json::error_handler_t::replace) << '\n';
}

void print_table(const std::vector<Recording>& recordings) {
  constexpr std::string_view kRow = "{:<20} {:<16} {:<8} {:>10} {:>12}  {:<24}  {}\n";
  if (recordings.empty()) {
    std::cout << "no recordings\n";
    return;
  }
  std::cout << fmt::format(kRow, "recording", "bus", "state", "messages", "bytes", "from", "to");
  for (const Recording& each : recordings) {
    const std::string bus = each.is_of_log ? "log " + each.bus : each.bus;
    const bool is_empty = each.messages == 0;
    std::cout << fmt::format(kRow, each.name, bus, name_of(each.state), each.messages, each.bytes,
                             is_empty ? "-" : date_of(each.from), is_empty ? "-" : date_of(each.to));
  }
}

struct ListWords {
  std::string url;
  bool json = false;
};

Expected<void> list(const ListWords& words, const nats::ServerOptions& options) {
  const auto url = read_url(words.url, "", options);
  if (!url) return tl::unexpected{url.error()};
  auto store = Store::open(url->server);
  if (!store) return tl::unexpected{store.error()};
  const auto recordings = store->all();
  if (!recordings) return tl::unexpected{recordings.error()};
  if (words.json)
    print_json(*recordings);
  else
    print_table(*recordings);
  return {};
}

}  // namespace

void add_list(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "list", "Print the recordings of a server");
  const auto words = std::make_shared<ListWords>();
  sub.add_option("URL", words->url, "nats://HOST[:PORT] or tls://...")->required()->type_name("");
  sub.add_flag("--json", words->json, "as JSON");
  sub.callback(
      [&run, words] { run = [words](const nats::ServerOptions& options) { return list(*words, options); }; });
}

}  // namespace canrec
