#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "farm/agent/host/outcomes.hpp"
#include "farm/agent/process/watched_process.hpp"
#include "farm/agent/unit/unit_folder.hpp"

namespace farm::agent {

/// What hubs are started with.
struct HubCommand {
  std::string program;               ///< path of canhub
  std::string server;                ///< URL of the NATS server, without a name behind it
  std::vector<std::string> options;  ///< who the hub is there, and whom it trusts

  /// The words for @p start, with its bus at @p path.
  [[nodiscard]] std::vector<std::string> words(const HubStart& start, const std::string& path) const;
};

/// The hubs of the buses of this host: a process `canhub` each.
class HubPrograms {
 public:
  /// What is passed by reference outlives this.
  HubPrograms(axisd::ServiceEvents& events, const Folders& folders, HubCommand command, Outcomes& outcomes)
      : events_{events}, folders_{folders}, command_{std::move(command)}, outcomes_{outcomes} {}

  /// Tells of those that run since an agent before. One that was started with other words is ended.
  void find();
  void start(const HubStart& start);
  void stop(const std::string& bus);

 private:
  struct Hub {
    std::unique_ptr<WatchedProcess> process;
    axisd::EventSource look;  ///< whether it serves already
    HubPrograms* owner = nullptr;
    std::string bus;
  };

  void find(const std::string& bus);
  void hold(const std::string& bus, ProcessHandle process);
  void look_at(const std::string& bus);
  [[nodiscard]] std::string note(const std::string& bus) const { return folders_.bus(bus) + "/hub.json"; }

  axisd::ServiceEvents& events_;
  const Folders& folders_;
  HubCommand command_;
  Outcomes& outcomes_;
  std::map<std::string, Hub> hubs_;
};

}  // namespace farm::agent
