#include "device/device.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include "device/node_policy.hpp"
#include "device/object_index.hpp"

namespace device {
namespace {

std::vector<canopen::EntryDescription> rows_of(const Configuration& configuration) {
  std::vector<drive::ObjectKind> kinds;
  for (const AxisSetup& axis : configuration.axes) kinds.push_back(axis.drive.kind);
  return object_rows(kinds);
}

/// The drive object of @p axis of @p unit, 0 being the control unit.
std::uint8_t object_of(const drive::DriveUnit& unit, std::size_t axis) noexcept {
  return axis == 0 ? drive::kControlUnitNumber : unit.axes()[axis - 1].number();
}

}  // namespace

Device::Device(const Configuration& configuration, canopen::FrameSink& sink, Listener& listener)
    : configuration_{configuration},
      sink_{sink},
      listener_{listener},
      address_{configuration, parameters_},
      unit_{unit_configuration(configuration), &parameters_},
      storage_{unit_, parameters_, listener, follow_ups_},
      retained_(drive::retained_image::size(unit_)),
      object_rows_{rows_of(configuration)},
      dictionary_{object_rows_, configuration.node_id},
      mirrored_parameters_{dictionary_, unit_, parameters_},
      presets_{configuration_, unit_},
      error_objects_{dictionary_, unit_},
      error_control_{dictionary_},
      sdo_identifiers_{dictionary_},
      node_{dictionary_, node_policy(configuration), sink, *this},
      process_data_{dictionary_, unit_, node_, parameters_, {*this, follow_ups_}},
      communication_{unit_, parameters_, node_, follow_ups_},
      window_{unit_, *this},
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
  unit_.cycle({awake.data(), axes_.size()}, clock_.seconds());
}

void Device::start(canopen::TimePoint now) noexcept {
  if (node_.state() == canopen::NmtState::Initialising) {
    clock_.begin(now);
    started_ = now;
    // Run-up: the first statusword is that of a unit that is ready.
    rested_until_ = now;
    process_data_.take_over(wired_at_start());
    run_cycle(true);
    show_values();
  }
  tell_time(now);
  const bool is_back = communication_.on_bus_state(BusState::Active);
  error_objects_.set_bus_off(false);
  node_.send_to(sink_);
  take_over_parameters();
  node_.start(now);
  error_objects_.update(node_);
  if (is_back) communication_.on_bus_back();
  show_messages();
}

void Device::on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
  now_ = now;
  if (communication_.is_bus_off()) return serve_off_the_bus(frame);
  serve(frame);
}

void Device::serve(const canopen::Frame& frame) noexcept {
  node_.on_frame(frame, now_);
  if (!follow_ups_.is_empty()) follow_up();
}

void Device::on_time(canopen::TimePoint now) noexcept {
  now_ = now;
  if (rpdo_monitor_.deadline() <= now) miss_rpdos();
  if (telegram_loss_.deadline() <= now) end_telegram_loss();
  if (communication_.restart_at() <= now) restart_bus();
  if (clock_.next() <= now) run_cycles();
  node_.on_time(now);
  if (!follow_ups_.is_empty()) follow_up();
}

/// Power-off of the drives and of what they were sent.
void Device::switch_off() noexcept {
  unit_.power_off();
  for (AxisObjects& axis : axes_) axis.forget_written();
  telegram_loss_.clear();
}

bool Device::is_moving() const noexcept {
  return !clock_.is_resting() && std::ranges::any_of(unit_.axes(), [](const drive::Axis& axis) {
    return axis.actual().pulses_enabled || std::abs(axis.actual().speed) > 0.0;
  });
}

std::uint32_t Device::held_back_axes() const noexcept {
  std::uint32_t axes = 0;
  for (const drive::Axis& axis : unit_.axes())
    if (axis.drive_train().is_held_back()) axes |= 1U << (axis.axis_number() - 1);
  return axes;
}

canopen::TimePoint Device::next_deadline() const noexcept {
  return std::min({node_.next_deadline(), clock_.next(), rpdo_monitor_.deadline(), telegram_loss_.deadline(),
                   communication_.restart_at()});
}

/// The time that faults and alarms are stamped with.
void Device::tell_time(canopen::TimePoint now) noexcept {
  now_ = now;
  const canopen::Duration running = now - started_.value_or(now);
  if (clock_.is_resting() && now > rested_until_) {
    unit_.rest(std::chrono::duration<double>{now - rested_until_}.count());
  }
  rested_until_ = now;
  const auto uptime = std::chrono::duration_cast<std::chrono::milliseconds>(running).count();
  unit_.set_time(static_cast<drive::Uptime>(uptime));
}

void Device::run_cycles() noexcept {
  tell_time(now_);
  const CycleClock::Due due = clock_.take_due(now_);
  skipped_cycles_ += static_cast<std::uint64_t>(due.skipped);
  telegram_loss_.on_cycle();
  for (std::int64_t i = 0; i < due.run; ++i) run_cycle(false);
  for (AxisObjects& axis : axes_) axis.end_cycles();
  publish();
  const bool infeed_rests = unit_.infeed() == nullptr || unit_.infeed()->is_quiescent();
  if (infeed_rests && std::ranges::all_of(axes_, &AxisObjects::is_idle)) clock_.rest();
}

/// What a cycle has led to: values change on the bus here and nowhere else.
void Device::publish() noexcept {
  follow_ups_.drop(FollowUp::ShowMessages);
  show_values();
  error_objects_.update(node_);
  node_.on_values_changed(now_);
}

/// Everything that the axes show.
void Device::show_values() noexcept {
  for (AxisObjects& axis : axes_) axis.publish();
}

void Device::wake() noexcept {
  for (AxisObjects& axis : axes_) axis.wake();
}

void Device::on_awake() noexcept {
  if (clock_.is_resting()) tell_time(now_);
  clock_.wake(now_);
}

canopen::Result<void> Device::write(const canopen::Entry&, std::int64_t value) {
  if (value != 0) return canopen::refuse(canopen::AbortCode::InvalidValue);
  tell_time(now_);
  unit_.for_each_object([this](const drive::DriveObject& object) { unit_.acknowledge(object.number()); });
  show_messages();
  return {};
}

tl::expected<void, drive::FaultError> Device::raise(std::size_t axis, std::uint16_t number, std::uint32_t value,
                                                    canopen::TimePoint now) noexcept {
  tell_time(now);
  auto raised = unit_.raise(object_of(unit_, axis), number, value);
  show_messages();
  return raised;
}

bool Device::acknowledge(std::size_t axis, canopen::TimePoint now) noexcept {
  tell_time(now);
  const bool clear = unit_.acknowledge(object_of(unit_, axis));
  show_messages();
  return clear;
}

void Device::set_line_voltage(double voltage, canopen::TimePoint now) noexcept {
  tell_time(now);
  unit_.set_line_voltage(voltage);
  wake();
}

void Device::set_input(unsigned number, bool high, canopen::TimePoint now) noexcept {
  tell_time(now);
  unit_.control_unit().terminals().apply(number, high);
  wake();
}

void Device::fail_encoder(std::size_t axis, motor::EncoderDefect defect, canopen::TimePoint now) noexcept {
  tell_time(now);
  unit_.axes()[axis - 1].fail_encoder(defect);
  axes_[axis - 1].wake();
}

void Device::set_load_torque(std::size_t axis, double torque, canopen::TimePoint now,
                             motor::LoadTorqueType type) noexcept {
  now_ = now;
  unit_.axes()[axis - 1].set_load_torque(torque, type);
  axes_[axis - 1].wake();
}

}  // namespace device
