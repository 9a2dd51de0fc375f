#include "device/device.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <iterator>

#include "device/object_index.hpp"

namespace device {
namespace {

constexpr double kCycleSeconds = std::chrono::duration<double>(Device::kCycle).count();

/// No remote frame ever asks for a TPDO of the unit.
constexpr std::array kTpdoTypes{canopen::TypeRange{0, 240}, canopen::TypeRange{254, 255}};

/// Where the unit differs from what most nodes do; the rest are the library's defaults.
constexpr canopen::Policy kPolicy{
    .unknown_command = canopen::UnknownCommand::Stop,
    .error_control_conflict = canopen::ErrorControlConflict::Refuse,
    .error_keeping = canopen::ErrorKeeping::Owner,
    .extended_identifiers = false,
    .sdo_block = false,
    .predefined_sdo_identifiers = true,
    .pdo_changes_in_operational = false,  // A08754
    .count_follows_entries = true,
    .tpdo_requests = false,
    .dummy_types = 0,
    .tpdo_types = kTpdoTypes,
};

canopen::Policy policy_of(const Configuration& configuration) noexcept {
  canopen::Policy policy = kPolicy;
  policy.sdo_block = configuration.sdo_block;
  policy.remote_frames = configuration.remote_frames;
  return policy;
}

drive::UnitConfiguration unit_of(const Configuration& configuration) {
  drive::UnitConfiguration unit{.axes = {}, .node_id = configuration.node_id};
  std::ranges::transform(configuration.axes, std::back_inserter(unit.axes), &AxisSetup::drive);
  return unit;
}

std::vector<canopen::EntryDescription> rows_of(const Configuration& configuration) {
  std::vector<drive::ObjectKind> kinds;
  for (const AxisSetup& axis : configuration.axes) kinds.push_back(axis.drive.kind);
  return object_rows(kinds);
}

constexpr std::uint16_t kPdosOfAnAxis = 0x40;

/// Objects with indices `first` to `last`.
struct ObjectRange {
  std::uint16_t first;
  std::uint16_t last;
};
/// The objects that show parameters of @p group, and what belongs to them.
constexpr ObjectRange objects_of(ParameterGroup group) noexcept {
  constexpr std::array kRanges{ObjectRange{0x1000, 0x9FFF}, ObjectRange{0x1000, 0x1FFF},
                               ObjectRange{0x6000, 0x9FFF}};
  return kRanges[static_cast<std::size_t>(group) - 1];
}

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
      unit_{unit_of(configuration), &parameters_},
      storage_{unit_, parameters_, listener},
      retained_(drive::retained_image::size(unit_)),
      object_rows_{rows_of(configuration)},
      dictionary_{object_rows_, configuration.node_id},
      mirrored_parameters_{dictionary_, unit_, parameters_},
      error_objects_{dictionary_, unit_},
      error_control_{dictionary_},
      sdo_identifiers_{dictionary_},
      node_{dictionary_, policy_of(configuration), sink, *this},
      communication_{unit_, parameters_, node_},
      window_{unit_, parameters_, *this} {
  node_.show(window_);
  apply_presets(ParameterGroup::All);
  AxisListener& listener_of_axes = *this;
  for (drive::Axis& axis : unit_.axes()) axes_.emplace_back(dictionary_, axis, listener_of_axes);
  dictionary_.own_write(object::kErrorField, 0, *this);
}

/// The configuration lies over the parameters of @p group, whatever they were before; what objects show of them is
/// brought into the dictionary.
void Device::apply_presets(ParameterGroup group) noexcept {
  for (std::size_t i = 0; i < configuration_.axes.size(); ++i) {
    for (const ParameterPreset& preset : configuration_.axes[i].presets) {
      if (!belongs_to(group, preset.number)) continue;
      drive::Axis& axis = unit_.axes()[i];
      if (axis.write(preset.number, preset.index, preset.value)) continue;
      // The rules of an object are those of a change, not of a beginning.
      [[maybe_unused]] const auto loaded = axis.load(preset.number, preset.index, preset.value);
      assert(loaded);
    }
  }
  const ObjectRange objects = objects_of(group);
  mirrored_parameters_.bring_out(objects.first, objects.last);
  for (AxisObjects& axis : axes_) axis.publish();
}

tl::expected<void, drive::image_format::Error> Device::load_parameters(std::span<const std::byte> image) noexcept {
  auto loaded = storage_.adopt(image);
  if (loaded) apply_presets(ParameterGroup::All);
  return loaded;
}

tl::expected<void, drive::image_format::Error> Device::load_retained(std::span<const std::byte> image) noexcept {
  return drive::retained_image::load(unit_, image);
}

std::span<const std::byte> Device::retained(canopen::TimePoint now) noexcept {
  tell_time(now);
  return drive::retained_image::save(unit_, retained_).value_or(std::span<const std::byte>{});
}

void Device::start(canopen::TimePoint now) noexcept {
  if (node_.state() == canopen::NmtState::Initialising) {
    started_ = last_cycle_ = now;
    // Run-up: the first statusword is that of a unit that is ready.
    for (std::size_t i = 0; i < axes_.size(); ++i) unit_.axes()[i].cycle(axes_[i].setpoints(), kCycleSeconds);
    for (AxisObjects& axis : axes_) axis.publish();
  }
  tell_time(now);
  communication_.on_bus_state(BusState::Active);
  error_objects_.set_bus_off(false);
  communication_.set_start_state();
  node_.start(now);
  error_objects_.update(node_);
}

void Device::on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
  now_ = now;
  node_.on_frame(frame, now);
  if (parameter_written_) follow_parameters();
  if (storage_.has_task()) carry_out_task();
}

void Device::on_parameter_written(std::uint8_t object) noexcept {
  parameter_written_ = true;
  if (object >= drive::kFirstAxisNumber) axes_[object - drive::kFirstAxisNumber].wake();
}

/// What the written parameters command besides their own effect, now that the answer is out.
void Device::follow_parameters() noexcept {
  parameter_written_ = false;
  publish();
  if (const auto command = communication_.take_command()) node_.command(*command, now_);
}

void Device::on_time(canopen::TimePoint now) noexcept {
  now_ = now;
  if (next_cycle() <= now) run_cycles();
  node_.on_time(now);
  if (storage_.has_task()) carry_out_task();
}

canopen::TimePoint Device::next_deadline() const noexcept {
  return std::min(node_.next_deadline(), next_cycle());
}

/// The time that faults and alarms are stamped with.
void Device::tell_time(canopen::TimePoint now) noexcept {
  now_ = now;
  const auto uptime = std::chrono::duration_cast<std::chrono::milliseconds>(now - started_).count();
  unit_.set_time(static_cast<drive::Uptime>(uptime));
}

void Device::run_cycles() noexcept {
  tell_time(now_);
  const std::int64_t due = (now_ - last_cycle_) / kCycle;
  const std::int64_t run = std::min(due, kMostCyclesAtOnce);
  last_cycle_ += due * kCycle;
  skipped_cycles_ += static_cast<std::uint64_t>(due - run);
  for (AxisObjects& axis : axes_) axis.run(run, kCycleSeconds);
  publish();
  resting_ = std::ranges::all_of(axes_, &AxisObjects::is_idle);
}

void Device::publish() noexcept {
  for (AxisObjects& axis : axes_) axis.publish();
  error_objects_.update(node_);
  node_.on_values_changed(now_);
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
  axes_[number / kPdosOfAnAxis].on_rpdo();
}

canopen::Result<void> Device::write(const canopen::Entry&, std::int64_t value) {
  if (value != 0) return canopen::refuse(canopen::AbortCode::InvalidValue);
  tell_time(now_);
  for (std::size_t axis = 0; axis <= axes_.size(); ++axis) unit_.acknowledge(object_of(axis));
  wake();
  publish();
  return {};
}

void Device::carry_out_task() noexcept {
  using Task = ParameterStorage::Task;
  switch (storage_.take_task()) {
    case Task::None:
      break;
    case Task::RestoreAll:
      return restore(ParameterGroup::All);
    case Task::RestoreCommunication:
      return restore(ParameterGroup::Communication);
    case Task::RestoreApplication:
      return restore(ParameterGroup::Application);
    case Task::Restart:
      return node_.command(canopen::NmtCommand::ResetNode, now_);
  }
}

/// The state of a new unit, at once: the vendor's departure from CiA 301, which waits for the next reset.
void Device::restore(ParameterGroup group) noexcept {
  storage_.reset(group);
  const ObjectRange objects = objects_of(group);
  dictionary_.restore(objects.first, objects.last);
  for (AxisObjects& axis : axes_) axis.forget_written();
  apply_presets(group);
  error_objects_.show_again();
  if (group != ParameterGroup::Application) node_.reload(now_);
  wake();
  publish();
}

void Device::on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept {
  tell_time(now_);
  if (to == canopen::NmtState::Initialising) {
    unit_.power_off();
    for (AxisObjects& axis : axes_) axis.forget_written();
  } else if (from == canopen::NmtState::Operational && configuration_.fault_on_leaving_operational) {
    leave_operational(to == canopen::NmtState::Stopped ? kToStopped : kToPreOperational);
  }
  const bool left = from == canopen::NmtState::Operational && to != canopen::NmtState::Initialising;
  if (left) storage_.on_operational_left();
  show_messages();
}

/// From within a call of the node, where TPDOs must not be judged yet: the cycle that follows does that.
void Device::show_messages() noexcept {
  error_objects_.update(node_);
  for (AxisObjects& axis : axes_) axis.publish();
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

void Device::on_reset(canopen::NmtCommand command) noexcept {
  const bool all = command == canopen::NmtCommand::ResetNode;
  const ParameterGroup group = all ? ParameterGroup::All : ParameterGroup::Communication;
  storage_.reload(group);
  apply_presets(group);
  communication_.set_start_state();
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

void Device::set_load_torque(std::size_t axis, double torque, canopen::TimePoint now) noexcept {
  now_ = now;
  unit_.axes()[axis - 1].set_load_torque(torque);
  axes_[axis - 1].wake();
}

}  // namespace device
