#include "tools/canhub/faults.hpp"

#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "can/bus_faults/bus_faults.hpp"
#include "can/userbus/protocol.hpp"

namespace canhub {

namespace {

using bus_faults::Refusal;
using nlohmann::json;
using userbus::StartStatus;

constexpr std::string_view kFaultRow = "{:>4} {:<8} {:>8} {:>8}  {}\n";

/// A fault as it would be written in words.
std::string words_of(const json& fault) {
  std::string words = fault.at("kind").get<std::string>();
  for (const auto& [key, value] : fault.items())
    if (key != "kind")
      words += fmt::format(" {}={}", key, value.is_string() ? value.get<std::string>() : value.dump());
  return words;
}

int refuse(std::ostream& errors, std::string_view option, const Refusal& refusal) {
  errors << fmt::format("canhub: {}{}\n", refusal.by_hub ? fmt::format("{}: ", option) : std::string{},
                        refusal.text);
  return static_cast<int>(refusal.by_hub ? StartStatus::Usage : StartStatus::Failed);
}

int print_faults(const Options& options, std::ostream& out, std::ostream& errors) {
  const auto faults = bus_faults::list(options.path);
  if (!faults) return refuse(errors, "--injected", faults.error());
  if (options.json) {
    out << json{{"faults", *faults}}.dump(-1, ' ', false, json::error_handler_t::replace) << '\n';
    return 0;
  }
  if (faults->empty()) {
    out << "no faults\n";
    return 0;
  }
  out << fmt::format(kFaultRow, "id", "state", "seen", "hits", "fault");
  for (const json& row : *faults)
    out << fmt::format(kFaultRow, row.at("id").get<std::uint32_t>(), row.at("state").get<std::string>(),
                       row.at("opportunities").get<std::uint64_t>(), row.at("hits").get<std::uint64_t>(),
                       words_of(row.at("fault")));
  return 0;
}

}  // namespace

int command_faults(const Options& options, std::ostream& out, std::ostream& errors) {
  for (const std::string& fault : options.inject) {
    const auto number = bus_faults::inject(options.path, fault);
    if (!number) return refuse(errors, "--inject", number.error());
    out << *number << '\n';
  }
  if (options.take_back) {
    const auto count = bus_faults::take_back(options.path, options.take_back->number);
    if (!count) return refuse(errors, "--take-back", count.error());
  }
  return options.injected ? print_faults(options, out, errors) : 0;
}

void load_faults(hub::Server& server, const Options& options) {
  for (const std::string& fault : options.with)
    if (const auto number = server.faults().inject(fault, server.now()); !number)
      throw UsageError{fmt::format("--with: {}", number.error())};
}

}  // namespace canhub
