#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "farm/door/service/door.hpp"
#include "tests/fakes/fake_messages.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/gateway/gateway_fixture.hpp"

namespace farm {

/// A door of host "a" on the farm "lab", without a server, before a daemon that has unit vcan.0/5, on the farm
/// vcan_0/5.
struct DoorTest : testing::Test {
  /// Begins anew.
  void start(bool read_only = false);
  /// The same, and waits until it is open.
  void open(bool read_only = false);
  /// Waits until @p is_done.
  void wait(const std::function<bool()>& is_done) { gateway::wait_until(events, is_done); }
  /// What the door answers to @p data on the subject for requests.
  nlohmann::json answer_to_text(std::string_view data);
  nlohmann::json answer_to(const nlohmann::json& request) { return answer_to_text(request.dump()); }
  /// The documents that have been published to @p subject.
  [[nodiscard]] std::vector<nlohmann::json> told(std::string_view subject) const;
  [[nodiscard]] bool is_served() const { return messages.subscriptions.contains(kRequests); }

  static constexpr const char* kRequests = "axisd.lab.vcan_0.5.rpc";
  static constexpr const char* kBeats = "axisd_host.lab.a.door";

  fakes::TemporaryDirectory folder;
  std::string path = folder.path("axisd.sock");
  axisd::ServiceEvents events{[] {}};
  axisd::Log log{axisd::LogLevel::Error};
  fakes::FakeMessages messages;
  std::unique_ptr<gateway::FakeDaemon> daemon;
  std::unique_ptr<gateway::Daemons> daemons;
  std::unique_ptr<Door> door;
};

}  // namespace farm
