#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/e2e/can_client.hpp"
#include "tests/e2e/notify_socket.hpp"
#include "tests/e2e/program.hpp"
#include "tests/e2e/test_bus.hpp"
#include "tests/fakes/child_process.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace e2e {

/// How a daemon is started.
struct DaemonOptions {
  std::string interface = served_interface();
  int node_id = 5;
  nlohmann::json axis{};    ///< the axis of the configuration file; null: none is written
  nlohmann::json supply{};  ///< of the configuration file, with an axis only; null: none
  nlohmann::json infeed{};  ///< of the configuration file, with an axis only; null: none
  nlohmann::json motor{};   ///< what motor.json beside that file holds; null: no such file
  int axes = 1;             ///< how many, the first one as above
  std::vector<std::string> environment{};
  std::string state_directory{};  ///< empty: one of its own
};

/// The built axisd as a child, with a temporary folder for its state, its control socket and its notify socket.
class DaemonProcess {
 public:
  /// Starts it; READY is to be waited for.
  explicit DaemonProcess(DaemonOptions options = {});

  /// Starts it again with everything as before; the former one must have ended.
  void start();
  /// Waits for READY=1; if it does not come, the result has the log.
  testing::AssertionResult is_ready();
  /// Ends it by @p signal: its exit status, or the negative number of a signal.
  int end(int signal);

  Program& program() { return *program_; }
  NotifySocket& notify() { return notify_; }
  std::string control_socket() const { return folder_.path("control.sock"); }
  /// A file in its folder.
  std::string path(const std::string& name) const { return folder_.path(name); }
  /// Number of lines of its log that contain @p text.
  std::size_t log_lines(const std::string& text);

  /// Runs axisctl with @p words on this daemon.
  fakes::Finished axisctl(std::vector<std::string> words) const;
  /// The result of `status`; throws std::runtime_error with the message of axisctl.
  nlohmann::json status() const;
  /// The counter @p name of the bus.
  std::uint64_t bus_counter(const std::string& name) const {
    return status().at("bus").at(name).get<std::uint64_t>();
  }

 private:
  std::vector<std::string> arguments() const;

  fakes::TemporaryDirectory folder_;
  NotifySocket notify_;
  DaemonOptions options_;
  std::unique_ptr<Program> program_;
};

/// Runs axisd with @p words to its end.
fakes::Finished run_axisd(std::vector<std::string> words);

/// A suite that shares one daemon and one client on its interface.
struct RunningDaemon : testing::Test {
  static inline std::unique_ptr<CanClient> can;  // on the bus before the daemon is
  static inline std::unique_ptr<DaemonProcess> daemon;

  /// For SetUpTestSuite().
  static void start(const DaemonOptions& options = {}) {
    can = std::make_unique<CanClient>(kTestInterface);
    daemon = std::make_unique<DaemonProcess>(options);
    ASSERT_TRUE(daemon->is_ready());
  }
  static void TearDownTestSuite() {
    daemon.reset();
    can.reset();
  }
  /// Every test starts behind a boot-up of node 5, in Operational.
  void SetUp() override {
    if (HasFatalFailure() || !daemon) GTEST_FAIL() << "no daemon";
    can->forget();
    can->send("000#8105");
    ASSERT_TRUE(can->wait_for("705#00"));
    can->send("000#0105");
    constexpr std::uint32_t kLastTpdo = 0x485;
    ASSERT_TRUE(can->wait_until("485#", [](const canopen::Frame& frame) { return frame.id == kLastTpdo; }));
  }
};

}  // namespace e2e
