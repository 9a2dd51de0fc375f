#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "daemon/control/handler.hpp"
#include "daemon/instance/instance.hpp"
#include "tests/fakes/fake_port.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {

/// A unit on a bus in memory, node 5, asked as the control socket asks it. Time is told: it stands still but in
/// run() and answer(). Other configurations are switched on by switch_on().
class ControlledUnit : public testing::Test {
 protected:
  using json = nlohmann::json;
  using Lines = std::vector<std::string>;

  ControlledUnit();

  /// Power-off, if it is on, and power-on with @p configuration; the state is kept.
  void switch_on(const Configuration& configuration);
  /// A unit of @p axes servo axes.
  static Configuration unit_of(std::size_t axes);

  /// What the handler of @p method answers to @p params.
  Outcome ask(std::string_view method, const json& params = json::object());
  /// Its result; a refusal is a failure of the test.
  json result_of(std::string_view method, const json& params = json::object());
  /// Why it refuses; a result is a failure of the test.
  control::Error error_of(std::string_view method, const json& params = json::object());

  /// Lets the unit run for @p duration.
  void run(std::chrono::milliseconds duration);
  /// What the unit sends at once to the frame @p text, in candump's notation.
  Lines answer(std::string_view text);
  /// What it has sent since the last call.
  Lines sent();
  /// Waits until a save that has begun is over.
  void await_write();

  Instance& unit() { return *instance_; }
  fakes::FakePort& port() { return *port_; }
  canopen::TimePoint now() const { return now_; }

 private:
  class Nobody final : public InstanceListener {
    void on_condition(const Instance&, Condition) noexcept override {}
  };

  fakes::TemporaryDirectory folder_;
  Log log_{LogLevel::Error};
  Nobody nobody_;
  Configuration configuration_;
  fakes::FakePort* port_ = nullptr;
  std::optional<Instance> instance_;
  canopen::TimePoint now_;
};

}  // namespace axisd
