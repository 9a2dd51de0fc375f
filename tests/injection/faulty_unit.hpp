#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "injection/json/fault_json.hpp"
#include "injection/kinds/unit_kinds.hpp"
#include "injection/wire/unit_faults.hpp"
#include "tests/device/test_unit.hpp"
#include "tests/fakes/candump.hpp"

namespace injection {

using namespace std::chrono_literals;

/// Frames in the notation of candump.
using Lines = std::vector<std::string>;

/// The fault that @p words say ("sdo.late delay_ms=50").
inline Fault fault_of(std::string_view words) {
  const auto fault = read_fault_words(words, unit_kinds());
  EXPECT_TRUE(fault) << (fault ? "" : fault.error().message());
  return fault.value_or(Fault{.kind = &unit_kinds().front()});
}

/// Node 5 with faults between it and a bus, and a clock that the test moves.
class FaultyUnit : private UnitHooks {
 public:
  explicit FaultyUnit(const device::Configuration& configuration = device::unit_with({}))
      : device{configuration, bus_, listener_} {}

  /// Loads a fault: its number.
  std::uint32_t inject(std::string_view words) {
    const auto id = faults.add(fault_of(words));
    EXPECT_TRUE(id) << (id ? "" : id.error());
    return id.value_or(0);
  }
  /// Power-on, a moment, and the command to Operational; what was sent is forgotten.
  void start_operational() {
    start();
    passes(100ms);
    says("000#0105");
    passes(device::Device::kCycle);
  }
  Lines start() {
    device.start(clock_);
    if (!faults.is_empty()) faults.on_start(clock_);
    run(clock_);
    return sent();
  }
  /// Operational, and through the states to Operation enabled.
  void enable() {
    start_operational();
    for (const char* const controlword : {"205#0600", "205#0700", "205#0F00"}) turns(controlword);
    ASSERT_EQ(number_at(0x6041) & 0x6F, 0x27);
  }
  /// A frame comes from the bus; what goes out at once.
  Lines says(std::string_view frame) {
    const canopen::Frame heard = fakes::frame_of(frame);
    if (faults.is_empty())
      device.on_frame(heard, clock_);
    else
      faults.on_frame(heard, clock_);
    if (deadline() <= clock_) run(clock_);
    return sent();
  }
  /// The same, and what the cycle that follows sends.
  Lines turns(std::string_view frame) {
    Lines lines = says(frame);
    for (std::string& line : passes(device::Device::kCycle)) lines.push_back(std::move(line));
    return lines;
  }
  /// Time passes; what goes out.
  Lines passes(canopen::Duration time) {
    const canopen::TimePoint end = clock_ + time;
    while (deadline() <= end) {
      clock_ = std::max(clock_, deadline());
      run(clock_);
      if (deadline() > clock_) continue;
      ADD_FAILURE() << "it asks for a moment that it has just been told";
      break;
    }
    clock_ = end;
    return sent();
  }
  /// What the dictionary says now.
  std::int64_t number_at(std::uint16_t index) const { return device.dictionary().stored(index, 0).value_or(-1); }

 private:
  canopen::TimePoint now() const noexcept override { return clock_; }
  void take(const canopen::Frame& frame, canopen::TimePoint now) noexcept override { device.on_frame(frame, now); }
  void power_cycle(canopen::TimePoint now) noexcept override { device.power_cycle(now); }
  void set_bus_state(device::BusState state, canopen::TimePoint now) noexcept override {
    device.on_bus_state(state, now);
  }
  void on_subscriptions_changed() noexcept override {}
  void on_loaded(bool any) noexcept override {
    device.send_to(any ? static_cast<canopen::FrameSink&>(faults) : bus_);
  }

  canopen::TimePoint deadline() const { return std::min(device.next_deadline(), faults.next_deadline()); }
  void run(canopen::TimePoint now) {
    faults.on_time(now);
    device.on_time(now);
    faults.settle(now);
  }
  Lines sent() {
    Lines lines;
    for (const canopen::Frame& frame : bus_.take()) lines.push_back(fakes::candump(frame));
    return lines;
  }

  canopen::TimePoint clock_{1h};
  fakes::VectorBus bus_;
  device::RecordingListener listener_;

 public:
  device::Device device;
  UnitFaults faults{device, bus_, *this};
};

}  // namespace injection
