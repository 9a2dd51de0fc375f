#include "cia402/face.hpp"

#include <algorithm>
#include <chrono>

#include "cia402/bus/node_policy.hpp"
#include "cia402/drive/drive_state.hpp"
#include "cia402/objects/object_index.hpp"
#include "device/bus/unit_time.hpp"

namespace cia402 {

Face::Face(const Configuration& configuration, unit::Runner& runner, canopen::FrameSink& sink,
           device::BusListener& listener, unit::ParameterKeeper& keeper)
    : runner_{runner},
      listener_{listener},
      keeper_{keeper},
      objects_{configuration},
      image_{objects_.dictionary, runner.unit()},
      node_{objects_.dictionary, node_policy(configuration.remote_frames), sink, *this},
      outlet_{node_, sink},
      lss_{node_.context(), *this},
      errors_(configuration.axes.size()),
      rpdo_actions_{node_.receive_pdos().size()} {
  for (std::size_t i = 0; i < configuration.axes.size(); ++i) {
    AxisListener& faults = *this;
    WriteListener& writes = *this;
    axes_.emplace_back(i + 1, objects_.dictionary, configuration.axes[i], faults, writes);
    links_.emplace_back(runner.unit().axes()[i]);
  }
}

/// Of an axis that rests nothing comes but what a master sends.
bool Face::rests(std::size_t axis) const noexcept {
  return !axes_[axis].axis().is_active() && (touched_ >> axis & 1U) == 0 &&
         runner_.unit().axes()[axis].is_quiescent();
}

void Face::bring() noexcept {
  shown_ = 0;
  const std::uint64_t begin = clock_us();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (rests(i)) continue;
    links_[i].bring(axes_[i].axis().lead(state_of(runner_.unit().axes()[i]), begin));
    shown_ |= unit::AxisMask{1} << i;
  }
  touched_ = 0;
}

unit::AxisMask Face::waiting() const noexcept {
  unit::AxisMask waiting = touched_;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (axes_[i].axis().is_active()) waiting |= unit::AxisMask{1} << i;
  return waiting;
}

void Face::show() noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if ((shown_ >> i & 1U) != 0) axes_[i].axis().show(state_of(runner_.unit().axes()[i]));
}

/// Into the cycle that runs: where a set-point was received.
TimeNs Face::instant() const noexcept {
  const TimeNs since = runner_.now() - runner_.clock().last();
  return std::clamp(since, TimeNs::zero(), kCycleTime);
}

/// Time of the device in µs: since it was switched on, or as 1012h has set it.
std::uint64_t Face::clock_us() const noexcept {
  const auto now =
      std::chrono::duration_cast<std::chrono::microseconds>(runner_.clock().last().time_since_epoch());
  return static_cast<std::uint64_t>(now.count() + clock_offset_us_);
}

void Face::wake_for(std::size_t axis) noexcept {
  touched_ |= unit::AxisMask{1} << axis;
  if (runner_.is_resting()) runner_.end_rest(device::unit_time(listener_.frame_arrival(now())));
  runner_.wake(unit::mask_of(axis + 1));
}

void Face::on_acting(std::size_t axis, ActingSet what) noexcept {
  wake_for(axis);
  axes_[axis].axis().act(what, instant());
}

void Face::act(AxisActions& actions) noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (actions[i] != 0) on_acting(i, actions[i]);
  actions = {};
}

void Face::on_frame(const canopen::Frame& frame) noexcept {
  node_.on_frame(frame, now());
  if (runner_.has_follow_ups()) runner_.follow_up();
  node_.on_values_changed(now());
}

void Face::on_rpdo(std::uint16_t number) noexcept {
  const AxisActions& brought = rpdo_actions_.of(number);
  if (rpdo_actions_.is_synchronous(number)) {
    for (std::size_t i = 0; i < axes_.size(); ++i) pending_[i] |= brought[i];
    return;
  }
  AxisActions actions = brought;
  act(actions);
}

void Face::on_synchronous_rpdos() noexcept {
  act(pending_);
}

void Face::on_sdo_written(const canopen::Entry& entry) noexcept {
  const bool is_of_rpdo = entry.index >= object::kRpdoParameter && entry.index < object::kTpdoParameter;
  if (is_of_rpdo && node_.state() == canopen::NmtState::Operational) follow_rpdos();
  if (entry.index == object::kVerifyConfiguration || !ObjectImage::is_kept(entry)) return;
  for (const std::uint8_t sub_index : {std::uint8_t{1}, std::uint8_t{2}})
    if (const canopen::Entry* const date = objects_.dictionary.lookup(object::kVerifyConfiguration, sub_index))
      objects_.dictionary.set(*date, 0);
}

canopen::Result<void> Face::write_object(const canopen::Entry& entry, std::int64_t value) noexcept {
  tell_time();
  auto written = objects_.dictionary.write(entry, value);
  if (written) on_sdo_written(entry);
  node_.on_values_changed(now());
  return written;
}

canopen::Result<void> Face::write_object(const canopen::Entry& entry,
                                         std::span<const std::uint8_t> text) noexcept {
  tell_time();
  return objects_.dictionary.write_text(entry, text);
}

void Face::on_error(std::size_t axis, ErrorCode error) noexcept {
  Errors& told = errors_[axis - 1];
  if (is_told_) return;
  if (told.count < Errors::kMost) told.codes[told.count++] = error.code;
  node_.raise_error(error.code, static_cast<std::uint16_t>(axis), error.error_register);
}

void Face::forget_errors(std::size_t axis) noexcept {
  Errors& told = errors_[axis];
  for (std::size_t i = 0; i < told.count; ++i)
    node_.clear_error(told.codes[i], static_cast<std::uint16_t>(axis + 1));
  told.count = 0;
}

bool Face::on_fault_reset(std::size_t axis) noexcept {
  if (!runner_.acknowledge(axis, runner_.now())) return false;
  forget_errors(axis - 1);
  return true;
}

bool Face::acknowledge(std::size_t axis) noexcept {
  if (axis == 0) return runner_.acknowledge(axis, runner_.now());
  tell_time();
  Axis& own = axes_[axis - 1].axis();
  if (own.state() == State::Fault) {
    own.reset_fault();
    node_.on_values_changed(now());
  } else {
    runner_.acknowledge(axis, runner_.now());
  }
  return own.state() != State::Fault && own.state() != State::FaultReactionActive;
}

bool Face::spoil(std::size_t number, const device::AxisDefect& defect) noexcept {
  if (axes_[number - 1].axis().spoil(defect)) wake_for(number - 1);
  return true;
}

/// Faults of the drives that are new, each as the fault of its axis.
void Face::show_messages(bool) noexcept {
  std::uint32_t newest = seen_sequence_;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const drive::Axis& drive = runner_.unit().axes()[i];
    for (const drive::FaultEntry& fault : drive.messages().faults()) {
      if (fault.sequence <= seen_sequence_) continue;
      newest = std::max(newest, fault.sequence);
      tell_time();  // what the node sends now has its time from that
      wake_for(i);
      axes_[i].axis().fault(error_code_of(fault.row->number), drive.actual().pulses_enabled);
    }
  }
  seen_sequence_ = newest;
}

}  // namespace cia402
