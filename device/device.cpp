#include "device/device.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cmath>
#include <utility>

#include "device/node_policy.hpp"
#include "device/object_index.hpp"

namespace device {
namespace {

constexpr double kCycleSeconds = std::chrono::duration<double>(Device::kCycle).count();

std::vector<canopen::EntryDescription> rows_of(const Configuration& configuration) {
  std::vector<drive::ObjectKind> kinds;
  for (const AxisSetup& axis : configuration.axes) kinds.push_back(axis.drive.kind);
  return object_rows(kinds);
}

// p0970 resets a drive object from p0010 = 30, which it ends.
constexpr std::uint16_t kResetObject = 970;
constexpr std::uint16_t kFilter = 10;

constexpr std::uint16_t kLeftOperational = 8701;
constexpr std::uint32_t kToPreOperational = 1;  // fault value
constexpr std::uint32_t kToStopped = 2;

/// The drive object of @p axis, 0 being the control unit.
constexpr std::uint8_t object_of(std::size_t axis) noexcept {
  return static_cast<std::uint8_t>(axis + drive::kControlUnitNumber);
}

}  // namespace

Device::Device(const Configuration& configuration, canopen::FrameSink& sink, Listener& listener)
    : configuration_{configuration},
      listener_{listener},
      unit_{unit_configuration(configuration), &parameters_},
      storage_{unit_, parameters_, listener},
      retained_(drive::retained_image::size(unit_)),
      object_rows_{rows_of(configuration)},
      dictionary_{object_rows_, configuration.node_id},
      mirrored_parameters_{dictionary_, unit_, parameters_},
      presets_{configuration_, unit_},
      error_objects_{dictionary_, unit_},
      error_control_{dictionary_},
      sdo_identifiers_{dictionary_},
      node_{dictionary_, node_policy(configuration), sink, *this},
      process_data_{dictionary_, unit_, node_, parameters_, *this},
      communication_{unit_, parameters_, node_},
      window_{unit_, parameters_, *this},
      rpdo_monitor_{parameters_} {
  node_.show(window_);
  bring_out(ParameterGroup::All);
  AxisListener& listener_of_axes = *this;
  for (drive::Axis& axis : unit_.axes())
    axes_.emplace_back(dictionary_, axis, process_data_.places(axis.axis_number()), listener_of_axes);
  dictionary_.own_write(object::kErrorField, 0, *this);
}

/// One cycle of the axes with what was received; @p all of them, or those that something has come for.
void Device::run_cycle(bool all) noexcept {
  std::array<bool, drive::kMostAxes> awake{};
  for (std::size_t i = 0; i < axes_.size(); ++i) awake[i] = axes_[i].receive() || all;
  process_data_.follow_mappings();
  process_data_.show_state();
  unit_.cycle({awake.data(), axes_.size()}, kCycleSeconds);
}

void Device::start(canopen::TimePoint now) noexcept {
  if (node_.state() == canopen::NmtState::Initialising) {
    last_cycle_ = now;
    started_ = now;
    // Run-up: the first statusword is that of a unit that is ready.
    rested_until_ = now;
    process_data_.take_over(wired_at_start());
    run_cycle(true);
    show_values();
  }
  tell_time(now);
  communication_.on_bus_state(BusState::Active);
  error_objects_.set_bus_off(false);
  take_over_parameters();
  node_.start(now);
  error_objects_.update(node_);
}

void Device::on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
  now_ = now;
  node_.on_frame(frame, now);
  process_data_.follow_mappings();
  if (parameter_written_) follow_parameters();
  if (storage_.has_task()) carry_out_task();
  if (alarm_changed_) publish();
}

void Device::on_parameter_written(std::uint8_t object, std::uint16_t number) noexcept {
  parameter_written_ = true;
  const bool left_reset = number == kResetObject && unit_.object(object)->read(kFilter) == 0.0;
  if (left_reset) restored_object_ = object;
  if (object == drive::kControlUnitNumber) return wake();
  axes_[object - drive::kFirstAxisNumber].wake();
}

/// What the written parameters command besides their own effect, now that the answer is out.
void Device::follow_parameters() noexcept {
  parameter_written_ = false;
  if (restored_object_ != 0) restore_object(std::exchange(restored_object_, std::uint8_t{0}));
  publish();
  if (const auto command = communication_.take_command()) node_.command(*command, now_);
}

/// The objects of drive object @p object follow its parameters, which are those of a new one.
void Device::restore_object(std::uint8_t object) noexcept {
  mirrored_parameters_.bring_out(object);
  process_data_.take_over(UnitProcessData::WiredBy::Factory);
  node_.reload(now_);
}

void Device::on_time(canopen::TimePoint now) noexcept {
  now_ = now;
  if (rpdo_monitor_.deadline() <= now) miss_rpdos();
  if (next_cycle() <= now) run_cycles();
  node_.on_time(now);
  if (storage_.has_task()) carry_out_task();
}

void Device::miss_rpdos() noexcept {
  rpdo_monitor_.stop();
  tell_time(now_);
  communication_.on_rpdos_missing();
  wake();
  publish();
}

bool Device::is_moving() const noexcept {
  return !resting_ && std::ranges::any_of(unit_.axes(), [](const drive::Axis& axis) {
    return axis.actual().pulses_enabled || std::abs(axis.actual().speed) > 0.0;
  });
}

canopen::TimePoint Device::next_deadline() const noexcept {
  return std::min({node_.next_deadline(), next_cycle(), rpdo_monitor_.deadline()});
}

/// The time that faults and alarms are stamped with.
void Device::tell_time(canopen::TimePoint now) noexcept {
  now_ = now;
  const canopen::Duration running = now - started_.value_or(now);
  if (resting_ && now > rested_until_) {
    unit_.rest(std::chrono::duration<double>{now - rested_until_}.count());
  }
  rested_until_ = now;
  const auto uptime = std::chrono::duration_cast<std::chrono::milliseconds>(running).count();
  unit_.set_time(static_cast<drive::Uptime>(uptime));
}

void Device::run_cycles() noexcept {
  tell_time(now_);
  const std::int64_t due = (now_ - last_cycle_) / kCycle;
  const std::int64_t run = std::min(due, kMostCyclesAtOnce);
  last_cycle_ += due * kCycle;
  skipped_cycles_ += static_cast<std::uint64_t>(due - run);
  for (std::int64_t i = 0; i < run; ++i) run_cycle(false);
  for (AxisObjects& axis : axes_) axis.end_cycles();
  publish();
  resting_ = std::ranges::all_of(axes_, &AxisObjects::is_idle);
}

void Device::publish() noexcept {
  alarm_changed_ = false;
  show_values();
  error_objects_.update(node_);
  node_.on_values_changed(now_);
}

/// Everything that the axes show.
void Device::show_values() noexcept {
  unit_.send_process_data();
  for (AxisObjects& axis : axes_) axis.publish();
}

void Device::wake() noexcept {
  for (AxisObjects& axis : axes_) axis.wake();
}

void Device::on_awake() noexcept {
  if (!resting_) return;
  resting_ = false;
  last_cycle_ += (now_ - last_cycle_) / kCycle * kCycle;  // the next cycle lies on the grid
}

void Device::on_rpdo(std::uint16_t number) noexcept {
  rpdo_monitor_.on_rpdo(now_);
  axes_[number / pdo::kStride].on_rpdo();
}

canopen::Result<void> Device::write(const canopen::Entry&, std::int64_t value) {
  if (value != 0) return canopen::refuse(canopen::AbortCode::InvalidValue);
  tell_time(now_);
  unit_.for_each_object([this](const drive::DriveObject& object) { unit_.acknowledge(object.number()); });
  wake();
  publish();
  return {};
}

void Device::on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept {
  tell_time(now_);
  rpdo_monitor_.stop();
  if (to == canopen::NmtState::Initialising) {
    unit_.power_off();
    for (AxisObjects& axis : axes_) axis.forget_written();
  } else if (from == canopen::NmtState::Operational && configuration_.fault_on_leaving_operational) {
    leave_operational(to == canopen::NmtState::Stopped ? kToStopped : kToPreOperational);
  }
  const bool left = from == canopen::NmtState::Operational && to != canopen::NmtState::Initialising;
  if (left) storage_.on_operational_left();
  if (from != canopen::NmtState::Initialising) process_data_.end_alarms();
  show_messages();
}

/// From within a call of the node, where TPDOs must not be judged yet: the cycle that follows does that.
void Device::show_messages() noexcept {
  error_objects_.update(node_);
  show_values();
  wake();
}

void Device::on_communication_error(canopen::CommunicationError error, std::uint16_t) noexcept {
  if (error != canopen::CommunicationError::LifeGuarding) return;
  tell_time(now_);
  communication_.on_life_time_over();
  show_messages();
}

void Device::on_bus_state(BusState state, canopen::TimePoint now) noexcept {
  tell_time(now);
  const bool is_back = communication_.on_bus_state(state);
  error_objects_.set_bus_off(communication_.is_bus_off());
  wake();
  publish();
  if (!is_back) return;
  node_.report(canopen::CommunicationError::BusOffRecovered, now);
  node_.report_recovery(canopen::CommunicationError::BusOffRecovered, now);
}

/// F08701 on every axis; the control unit has no part in it.
void Device::leave_operational(std::uint32_t value) noexcept {
  for (drive::Axis& axis : unit_.axes()) {
    [[maybe_unused]] const auto raised = axis.raise(kLeftOperational, value);
    assert(raised);
  }
}

tl::expected<void, drive::FaultError> Device::raise(std::size_t axis, std::uint16_t number, std::uint32_t value,
                                                    canopen::TimePoint now) noexcept {
  tell_time(now);
  auto raised = unit_.raise(object_of(axis), number, value);
  wake();
  publish();
  return raised;
}

bool Device::acknowledge(std::size_t axis, canopen::TimePoint now) noexcept {
  tell_time(now);
  const bool clear = unit_.acknowledge(object_of(axis));
  wake();
  publish();
  return clear;
}

void Device::set_line_voltage(double voltage, canopen::TimePoint now) noexcept {
  tell_time(now);
  unit_.set_line_voltage(voltage);
  wake();
}

void Device::fail_encoder(std::size_t axis, motor::EncoderDefect defect, canopen::TimePoint now) noexcept {
  tell_time(now);
  unit_.axes()[axis - 1].fail_encoder(defect);
  axes_[axis - 1].wake();
}

void Device::set_load_torque(std::size_t axis, double torque, canopen::TimePoint now) noexcept {
  now_ = now;
  unit_.axes()[axis - 1].set_load_torque(torque);
  axes_[axis - 1].wake();
}

}  // namespace device
