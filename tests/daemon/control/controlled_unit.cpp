#include "tests/daemon/control/controlled_unit.hpp"

#include <algorithm>

#include <poll.h>

#include "daemon/control/events/carry_out.hpp"
#include "daemon/control/handlers.hpp"
#include "service/clock.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/fakes/fake_link.hpp"

namespace axisd {

ControlledUnit::ControlledUnit() {
  switch_on(unit_of(1));
}

Configuration ControlledUnit::unit_of(std::size_t axes) {
  Configuration configuration;
  configuration.node_id = 5;
  configuration.axes = default_axes(axes);
  return configuration;
}

void ControlledUnit::switch_on(const Configuration& configuration) {
  if (instance_) instance_->power_off();
  instance_.reset();
  configuration_ = configuration;
  auto port = std::make_unique<fakes::FakePort>();
  port_ = port.get();
  instance_.emplace(configuration_, bus::Connection{std::move(port), std::make_unique<fakes::FakeLink>()},
                    folder_.path(), log_, nobody_);
  instance_->load();
  instance_->start();
  now_ = read_clock();
  run(std::chrono::milliseconds{20});
  port_->sent.clear();
}

Outcome ControlledUnit::ask(std::string_view method, const json& params) {
  const Handler* const handler = find_handler(method);
  if (handler == nullptr) return refuse(control::ErrorCode::UnknownMethod, std::string{method});
  return carry_out(*handler, {*instance_, now_}, params);
}

nlohmann::json ControlledUnit::result_of(std::string_view method, const json& params) {
  const Outcome outcome = ask(method, params);
  EXPECT_TRUE(outcome) << method << ' ' << params << ": " << outcome.error().message;
  return outcome.value_or(json::object());
}

control::Error ControlledUnit::error_of(std::string_view method, const json& params) {
  const Outcome outcome = ask(method, params);
  EXPECT_FALSE(outcome) << method << ' ' << params << ": " << *outcome;
  return outcome ? control::Error{control::ErrorCode::Malformed, {}} : outcome.error();
}

void ControlledUnit::run(std::chrono::milliseconds duration) {
  const canopen::TimePoint end = now_ + duration;
  while (now_ < end) {
    now_ = std::clamp(instance_->bus().next_deadline(), now_ + std::chrono::microseconds{1}, end);
    instance_->bus().turn(now_, false);
    instance_->look_around();
  }
}

ControlledUnit::Lines ControlledUnit::answer(std::string_view text) {
  port_->sent.clear();
  port_->arrived.push_back(fakes::frame_of(text));
  instance_->bus().turn(now_, true);
  return sent();
}

ControlledUnit::Lines ControlledUnit::sent() {
  Lines lines;
  for (const canopen::Frame& frame : port_->sent) lines.push_back(fakes::candump(frame));
  port_->sent.clear();
  return lines;
}

void ControlledUnit::await_write() {
  const Instance::RareSource source = instance_->rare_sources().front();
  while (instance_->device().is_saving()) {
    pollfd ended{source.descriptor, POLLIN, 0};
    EXPECT_EQ(::poll(&ended, 1, -1), 1);
    (source.instance->*source.handle)();
  }
}

}  // namespace axisd
