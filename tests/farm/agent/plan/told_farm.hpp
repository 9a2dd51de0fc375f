#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "farm/agent/plan/kept_state.hpp"
#include "farm/agent/plan/plan.hpp"
#include "tests/farm/agent/plan/told_server.hpp"

/// A farm at times that a test tells: a server, and hosts with agents, doors and processes.
namespace told {

using namespace std::chrono_literals;
using canopen::Duration;
using canopen::TimePoint;

class Farm;

/// A host: its agent may die and begin anew, its processes and its door go on without it.
class Host {
 public:
  struct Unit {
    enum class State { Starting, On, Stopping } state = State::Starting;
    TimePoint until{};  ///< Starting, Stopping
    std::string configuration;
    int value = 0;  ///< what it has saved last, or was started with
  };
  /// What lies in the folder of a unit.
  struct Folder {
    farm::agent::KeptState kept;
    int value = 0;
  };

  Host(Farm& farm, std::string name, std::uint32_t capacity);

  void boot();        ///< an agent and a door begin
  void kill_agent();  ///< units, hubs and door go on
  void start_agent();
  void kill();  ///< all at once
  void cut();   ///< nothing goes to the server or comes from there
  void heal();
  void kill_unit(const UnitName& unit);
  void save(const UnitName& unit);
  void turn();  ///< what is to be done at the present time

  [[nodiscard]] bool runs(const UnitName& unit) const {
    return units.contains(unit) && units.at(unit).state == Unit::State::On;
  }
  [[nodiscard]] bool is_reached() const { return !is_cut; }
  /// Whether nothing was wrong with it for a while: an agent, and contact to the server.
  [[nodiscard]] bool is_well(Duration since) const;

  const std::string name;
  std::uint32_t capacity;
  std::set<std::string> buses;
  std::unique_ptr<farm::agent::Plan> plan;  ///< nullptr: its agent is dead
  std::uint64_t instance = 0;
  bool has_door = false;
  std::uint64_t door_instance = 0;
  bool is_cut = false;
  bool cannot_judge = false;  ///< configurations
  std::map<UnitName, Unit> units;
  std::map<UnitName, Folder> folders;
  std::set<std::string> hubs;
  std::set<UnitName> foreign;  ///< units of daemons that no agent has started
  std::vector<std::string> notices;
  unsigned starts = 0;

  /// Has @p what done with the agent in a moment, if that, and its connection, are still there then.
  void later(std::function<void(farm::agent::Plan&)> what);
  /// The same of what does not need the connection.
  void later_here(std::function<void(farm::agent::Plan&)> what);
  void tell(Bucket bucket, const farm::Entry& entry);

 private:
  struct Event {
    TimePoint time;
    std::function<void(farm::agent::Plan&)> what;
    bool needs_server;
  };

  void connect();
  void turn_processes();
  void carry_out(const farm::agent::Orders& orders);
  void carry_out(const farm::agent::PlaceWrite& write);
  void start(const farm::agent::UnitStart& unit);
  void upload(const UnitName& unit);
  void beat();
  void beat_door();

  Farm& farm_;
  std::list<Event> events_;
  TimePoint last_ = {};  ///< time of the last event
  TimePoint well_since_ = {};
  TimePoint cut_since_ = {};
  TimePoint connect_at_ = canopen::kNever;
  TimePoint next_beat_ = {};
  bool is_down_told_ = false;
  bool is_changed_ = true;
};

class Farm {
 public:
  explicit Farm(std::uint32_t seed = 1) : random{seed} {}

  Host& add(const std::string& name, std::uint32_t capacity = 100);
  /// Time goes on.
  void pass(Duration time);
  /// Time goes on until @p condition; false if it has not come after @p limit.
  [[nodiscard]] bool pass_until(const std::function<bool()>& condition, Duration limit = 60s);

  /// A user puts or deletes a document.
  void want(const UnitName& unit, const std::string& document = R"({"configuration":{}})");
  void put(Bucket bucket, const std::string& key, const std::string& value);
  void remove(Bucket bucket, const std::string& key);
  void lose_server();

  [[nodiscard]] farm::Place place(const UnitName& unit) const;
  /// Where @p unit runs.
  [[nodiscard]] std::vector<std::string> hosts_of(const UnitName& unit) const;
  [[nodiscard]] bool runs_once(const UnitName& unit) const { return hosts_of(unit).size() == 1; }
  /// A line for each unit that two hosts run though both are well; empty if there is none.
  [[nodiscard]] std::string doubles() const;

  Duration between(Duration low, Duration high) {
    return Duration{std::uniform_int_distribution<Duration::rep>{low.count(), high.count()}(random)};
  }
  [[nodiscard]] int below(int limit) { return std::uniform_int_distribution<>{0, limit - 1}(random); }

  TimePoint now{1h};
  std::mt19937 random;
  Server server;
  std::list<Host> hosts;
  std::vector<std::string> faults;  ///< what should never happen
  std::uint64_t last_instance = 0;
};

}  // namespace told
