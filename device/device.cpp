#include "device/device.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>

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
    .pdo_changes_in_operational = false,  // A08754
    .count_follows_entries = true,
    .tpdo_requests = false,
    .dummy_types = 0,
    .tpdo_types = kTpdoTypes,
};

/// Objects whose writing over SDO is an input of the drive, as an RPDO is.
constexpr std::array kInputs{object::kControlword, object::kTargetVelocity, object::kTargetTorque,
                             object::kModesOfOperation, object::kErrorField};

canopen::Policy policy_of(const Configuration& configuration) noexcept {
  canopen::Policy policy = kPolicy;
  policy.sdo_block = configuration.sdo_block;
  policy.remote_frames = configuration.remote_frames;
  return policy;
}

constexpr std::uint16_t kLeftOperational = 8701;
constexpr std::uint32_t kToPreOperational = 1;  // fault value
constexpr std::uint32_t kToStopped = 2;

}  // namespace

Device::Device(const Configuration& configuration, canopen::FrameSink& sink, Listener& listener)
    : fault_on_leaving_operational_{configuration.fault_on_leaving_operational},
      presets_{configuration.presets},
      listener_{listener},
      axis_{configuration.axis},
      object_rows_{object_rows(configuration.axis_types)},
      dictionary_{object_rows_, configuration.node_id},
      process_data_{dictionary_, drive::BusScaling{axis_.parameters()}},
      parameter_objects_{dictionary_, axis_, drive::BusScaling{axis_.parameters()}, *this},
      error_objects_{dictionary_, axis_},
      error_control_{dictionary_},
      sdo_identifiers_{dictionary_},
      node_{dictionary_, policy_of(configuration), sink, *this} {
  apply_presets();
  for (const std::uint16_t index : kInputs) dictionary_.own_write(index, 0, *this);
}

void Device::apply_presets() noexcept {
  for (const ParameterPreset& preset : presets_) {
    [[maybe_unused]] const auto written = axis_.write(preset.number, preset.value);
    assert(written);
  }
}

void Device::start(canopen::TimePoint now) noexcept {
  now_ = now;
  if (node_.state() == canopen::NmtState::Initialising) {
    last_cycle_ = now;
    axis_.cycle(setpoints(), kCycleSeconds);  // run-up: the first statusword is that of a unit that is ready
    process_data_.publish(axis_.actual());
  }
  node_.start(now);
}

void Device::on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept {
  now_ = now;
  node_.on_frame(frame, now);
}

void Device::on_time(canopen::TimePoint now) noexcept {
  now_ = now;
  if (next_cycle() <= now) run_cycles();
  node_.on_time(now);
}

canopen::TimePoint Device::next_deadline() const noexcept {
  return std::min(node_.next_deadline(), next_cycle());
}

void Device::run_cycles() noexcept {
  const std::int64_t due = (now_ - last_cycle_) / kCycle;
  const std::int64_t run = std::min(due, kMostCyclesAtOnce);
  last_cycle_ += due * kCycle;
  skipped_cycles_ += static_cast<std::uint64_t>(due - run);
  drive::Setpoints wanted = setpoints();
  const std::uint16_t latest = wanted.controlword;
  for (std::int64_t i = 0; i < run; ++i) {
    wanted.controlword = written_controlwords_.take().value_or(latest);
    axis_.cycle(wanted, kCycleSeconds);
  }
  publish();
  idle_ = axis_.is_quiescent() && written_controlwords_.is_empty();
}

void Device::publish() noexcept {
  process_data_.publish(axis_.actual());
  error_objects_.update(node_);
  node_.on_values_changed(now_);
}

void Device::wake() noexcept {
  if (!idle_) return;
  idle_ = false;
  last_cycle_ += (now_ - last_cycle_) / kCycle * kCycle;  // the next cycle lies on the grid
}

void Device::on_rpdo(std::uint16_t) noexcept {
  // A controlword in process data is the newer one; an RPDO without any leaves the written ones in force.
  const bool overwritten = process_data_.controlword() != written_controlwords_.newest();
  if (overwritten && !written_controlwords_.is_empty()) written_controlwords_.clear();
  wake();
}

canopen::Result<void> Device::write(const canopen::Entry& entry, std::int64_t value) {
  if (entry.index == object::kErrorField) {
    if (value != 0) return canopen::refuse(canopen::AbortCode::InvalidValue);
    acknowledge(now_);
    return {};
  }
  if (entry.index == object::kControlword) written_controlwords_.put(static_cast<std::uint16_t>(value));
  wake();
  return {};
}

void Device::on_nmt_state(canopen::NmtState from, canopen::NmtState to) noexcept {
  if (to == canopen::NmtState::Initialising) {
    axis_.power_off();
    written_controlwords_.clear();
  } else if (from == canopen::NmtState::Operational && fault_on_leaving_operational_) {
    [[maybe_unused]] const auto raised =
        axis_.raise(kLeftOperational, to == canopen::NmtState::Stopped ? kToStopped : kToPreOperational);
  }
  error_objects_.update(node_);
  process_data_.publish(axis_.actual());
  wake();
}

void Device::on_reset(canopen::NmtCommand command) noexcept {
  if (command == canopen::NmtCommand::ResetNode) {
    axis_.restore_parameters();
    apply_presets();
  }
  process_data_.publish(axis_.actual());  // the dictionary holds its initial values
}

tl::expected<void, drive::FaultError> Device::raise(std::uint16_t number, canopen::TimePoint now) noexcept {
  now_ = now;
  auto raised = axis_.raise(number);
  wake();
  publish();
  return raised;
}

bool Device::acknowledge(canopen::TimePoint now) noexcept {
  now_ = now;
  const bool clear = axis_.acknowledge();
  withdraw_alarms();
  wake();
  publish();
  return clear;
}

/// Alarms that were raised from outside have no cause that could end; the acknowledgement stands for it.
void Device::withdraw_alarms() noexcept {
  while (true) {
    const auto alarms = axis_.messages().alarms();
    const auto raised = std::find_if(alarms.begin(), alarms.end(), [](const drive::FaultEntry& entry) {
      return entry.cause == drive::Cause::Gone;
    });
    if (raised == alarms.end()) return;
    axis_.withdraw(raised->row->number);
  }
}

void Device::set_load_torque(double torque, canopen::TimePoint now) noexcept {
  now_ = now;
  axis_.set_load_torque(torque);
  wake();
}

}  // namespace device
