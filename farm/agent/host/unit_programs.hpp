#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "farm/agent/host/outcomes.hpp"
#include "farm/agent/host/stored_state.hpp"
#include "farm/agent/process/ready_message.hpp"
#include "farm/agent/process/watched_process.hpp"
#include "farm/agent/unit/unit_folder.hpp"

namespace farm::agent {

/// What units are started with.
struct UnitCommand {
  std::string program;               ///< path of axisd
  std::vector<std::string> options;  ///< that all units have

  [[nodiscard]] std::vector<std::string> words(const Folders& folders, const UnitName& unit) const;
};

/// The units of this host: a process `axisd` each. Some are started at the same time, the others wait for their
/// turn: starting takes the processor, and units that run need it.
class UnitPrograms {
 public:
  /// That are being started at the same time.
  static constexpr std::size_t kMostStarting = 4;

  /// What is passed by reference outlives this.
  UnitPrograms(axisd::ServiceEvents& events, const Folders& folders, UnitCommand command, StoredState& state,
               Outcomes& outcomes)
      : events_{events}, folders_{folders}, command_{std::move(command)}, state_{state}, outcomes_{outcomes} {}

  /// Tells of those that run since an agent before.
  void find();
  void start(UnitStart start);
  void stop(const UnitName& name);

 private:
  /// A unit that was to be started and has not ended.
  struct Unit {
    UnitStart start;
    std::uint64_t attempt = 0;
    bool is_starting = false;  ///< it has its turn
    std::unique_ptr<WatchedProcess> process;
    std::unique_ptr<ReadyMessage> ready;
    axisd::EventSource patience;
    UnitPrograms* owner = nullptr;
  };

  void begin_next();
  void begin(Unit& unit);
  void begin_beside(Unit& unit, ProcessHandle other);
  void launch(const UnitName& name, std::uint64_t attempt, const tl::expected<void, std::string>& prepared);
  [[nodiscard]] tl::expected<ProcessHandle, std::string> spawn(Unit& unit);
  void hold(Unit& unit, ProcessHandle process);
  void await_ready(Unit& unit);
  void on_ready(const UnitName& name);
  void on_end(const UnitName& name, const ProcessEnd& end);
  [[nodiscard]] bool adopt(Unit& unit);
  void give_up(const UnitName& name, const std::string& why);

  axisd::ServiceEvents& events_;
  const Folders& folders_;
  UnitCommand command_;
  StoredState& state_;
  Outcomes& outcomes_;
  std::map<UnitName, Unit> units_;
  std::deque<UnitName> waiting_;
  std::size_t starting_ = 0;
  std::uint64_t last_attempt_ = 0;
};

}  // namespace farm::agent
