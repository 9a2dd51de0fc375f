#pragma once

#include <functional>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>

#include "tools/axisctl/connection/client.hpp"
#include "tools/axisctl/connection/target.hpp"
#include "tools/axisctl/print/printer.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}
namespace farm {
class MirrorThread;
}

namespace axisctl {

/// What the options in front of a subcommand ask for.
struct Settings {
  Address address;
  std::string interface {};  ///< --interface as it was written; empty: not given
  bool json = false;         ///< for programs
  Style style{};
  farm::MirrorThread* farm = nullptr;  ///< whose units are meant; nullptr: those of this machine
};

/// What the chosen subcommand does.
using Run = std::function<Expected<void>(const Settings& settings)>;

/// Adds a subcommand with its words and options to the command line; chosen, it puts what it does into @p run.
using AddCommand = void (*)(CLI::App& app, Run& run);

/// The subcommands that are more than a row of the protocol, in the order of the help.
[[nodiscard]] std::span<const AddCommand> commands() noexcept;

/// A subcommand for each row of control::kMethods that has one.
void add_methods(CLI::App& app, Run& run);

void add_units(CLI::App& app, Run& run);
void add_wait(CLI::App& app, Run& run);
void add_watch(CLI::App& app, Run& run);
void add_monitor(CLI::App& app, Run& run);
void add_trace(CLI::App& app, Run& run);
void add_record(CLI::App& app, Run& run);
void add_page(CLI::App& app, Run& run);
void add_run(CLI::App& app, Run& run);
void add_fleet(CLI::App& app, Run& run);
void add_step(CLI::App& app, Run& run);
void add_compare(CLI::App& app, Run& run);
void add_replay(CLI::App& app, Run& run);
void add_twin(CLI::App& app, Run& run);

/// A subcommand of @p app, or the one of that name that it has.
CLI::App& subcommand(CLI::App& app, std::string_view name, std::string_view summary);

/// A connection to the unit that is meant.
class Session {
 public:
  [[nodiscard]] static Expected<Session> open(const Settings& settings);
  /// The same; of a farm of which no unit is named, to all its units.
  [[nodiscard]] static Expected<Session> open_to_all(const Settings& settings);

  /// Asks for @p method of the unit.
  [[nodiscard]] Expected<nlohmann::json> ask(std::string_view method,
                                             nlohmann::json params = nlohmann::json::object());
  Client& client() noexcept { return client_; }

 private:
  Session(Client client, std::string unit) : client_{std::move(client)}, unit_{std::move(unit)} {}

  Client client_;
  std::string unit_;
};

/// A connection to the farm of @p settings, which has one.
[[nodiscard]] Expected<Client> connect_to_farm(const Settings& settings);
/// Refuses what @p what does if @p settings have a farm, for the reason @p why.
Expected<void> expect_no_farm(const Settings& settings, std::string_view what, std::string_view why);

/// Writes @p line and a newline to standard output, at once. A failure if it cannot be written.
Expected<void> print_line(std::string_view line);

}  // namespace axisctl
