#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "can/clock/time_share.hpp"
#include "tools/axisctl/connection/client.hpp"
#include "tools/axisctl/scenario/reader/scenario.hpp"
#include "tools/axisctl/scenario/run/bench.hpp"
#include "tools/axisctl/scenario/run/process.hpp"
#include "tools/axisctl/scenario/run/recording_plan.hpp"
#include "tools/axisctl/scenario/run/workshop.hpp"

namespace scenario {

/// A drive unit of the run: its process and the way to its control socket.
struct Unit {
  UnitPlan plan;
  Process process;
  axisctl::Client client;
};

/// A program under test.
struct Program {
  ProgramPlan plan;
  std::unique_ptr<Process> process{};  ///< none: not started yet
};

/// Whether units are recorded from their start on.
enum class Recorded : std::uint8_t { No, Yes };

/// The bus of a run.
struct BusWish {
  std::string address{};  ///< of one that is there; empty: a private one is served
  std::string time{};     ///< of a private one, as canhub takes it; empty: the machine's
};

/// Everything that takes part in a run: the hub of the bus, units and programs, as processes.
class Stations {
 public:
  /// A private bus has the bit rate of @p scenario.
  Stations(const Scenario& scenario, const Workshop& workshop, BusWish bus, Recorded recorded)
      : scenario_{scenario},
        workshop_{workshop},
        bus_{std::move(bus.address)},
        wish_{std::move(bus.time)},
        recorded_{recorded} {}
  ~Stations();
  Stations(const Stations&) = delete;
  Stations& operator=(const Stations&) = delete;

  /// Serves the bus if it is private. All errors here are one line.
  [[nodiscard]] tl::expected<void, std::string> start_bus();
  /// Asks axisd whether it takes the configurations of all units; "/units/0/config/axes: expected ...".
  [[nodiscard]] tl::expected<void, std::string> check_units() const;
  /// Starts all units and waits on @p bench until they answer.
  [[nodiscard]] tl::expected<void, std::string> start_units(Bench& bench);
  /// Starts the programs that no step starts.
  [[nodiscard]] tl::expected<void, std::string> start_programs();
  [[nodiscard]] tl::expected<void, std::string> start(Program& program);

  /// Whether the bus was made for this run.
  [[nodiscard]] bool has_private_bus() const noexcept { return hub_ != nullptr; }
  /// Address of the bus, for this program and its children.
  [[nodiscard]] const std::string& bus() const noexcept { return bus_; }
  /// The time of the bus, if it is not the machine's; from start_bus() on.
  [[nodiscard]] bus::TimeShare* time() const noexcept { return time_.get(); }
  /// Path of a private bus.
  [[nodiscard]] std::string bus_path() const { return workshop_.path("bus"); }
  /// The unit of that name; the only one if @p keys has none.
  [[nodiscard]] Unit& unit(const nlohmann::json& keys);
  /// The unit of @p plan; nullptr if it has not come up.
  [[nodiscard]] Unit* find(const UnitPlan& plan);
  [[nodiscard]] Program& program(const std::string& name);
  [[nodiscard]] std::vector<std::unique_ptr<Program>>& programs() noexcept { return programs_; }
  /// Why the run cannot go on: a unit or the hub has ended; nothing if all is well.
  [[nodiscard]] std::optional<std::string> find_lost();

 private:
  void join_time();
  [[nodiscard]] tl::expected<void, std::string> start_unit(const UnitPlan& plan, Signals recorded, Bench& bench);
  /// Takes the boot-up message of a unit that has come up, so that no step sees it; it may be missing on purpose.
  static void see_boot_up(const UnitPlan& plan, Bench& bench);
  [[nodiscard]] tl::expected<Process, std::string> launch(const Command& command) const;
  /// Writes what axisd is to read, with a recording of the signals @p recorded if units are recorded.
  [[nodiscard]] std::string write_configuration(const UnitPlan& plan, Signals recorded) const;

  const Scenario& scenario_;
  const Workshop& workshop_;
  std::string bus_;
  std::string wish_;  ///< whose time a private bus is to have
  Recorded recorded_;
  std::unique_ptr<Process> hub_{};
  std::unique_ptr<bus::TimeShare> time_{};
  std::vector<std::unique_ptr<Unit>> units_{};
  std::vector<std::unique_ptr<Program>> programs_{};
};

}  // namespace scenario
