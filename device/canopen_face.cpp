#include "device/canopen_face.hpp"

#include <algorithm>
#include <array>

#include "device/bus/node_policy.hpp"
#include "device/objects/object_index.hpp"

namespace device {

CanopenFace::CanopenFace(const Configuration& configuration, unit::Runner& runner, canopen::FrameSink& sink,
                         BusListener& listener)
    : runner_{runner},
      listener_{listener},
      fault_on_leaving_operational_{configuration.fault_on_leaving_operational},
      address_{configuration, runner.parameters()},
      objects_{configuration},
      mirrored_parameters_{objects_.dictionary, runner.unit(), runner.parameters()},
      error_objects_{objects_.dictionary, runner.unit()},
      node_{objects_.dictionary, node_policy(configuration), sink, *this},
      process_data_{objects_.dictionary, runner.unit(), node_, runner.parameters(), {*this, follow_ups_}},
      communication_{runner.unit(), runner.parameters(), follow_ups_, {node_, sink}},
      window_{runner.unit(), *this},
      reception_{runner, node_, communication_} {
  node_.show(window_);
  name_groups();
  for (drive::Axis& axis : runner.unit().axes())
    axes_.emplace_back(objects_.dictionary, axis, process_data_.places(axis.axis_number()), runner);
  objects_.dictionary.own_write(object::kErrorField, 0, *this);
}

void CanopenFace::bring() noexcept {
  reception_.on_cycle();
  for (AxisObjects& axis : axes_) axis.receive();
  process_data_.follow_mappings();
  process_data_.show_state();
}

unit::AxisMask CanopenFace::waiting() const noexcept {
  unit::AxisMask waiting = 0;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (axes_[i].is_waiting()) waiting |= unit::AxisMask{1} << i;
  return waiting;
}

void CanopenFace::show() noexcept {
  for (AxisObjects& axis : axes_) axis.publish();
}

void CanopenFace::start() noexcept {
  const bool is_back = communication_.on_bus_state(BusState::Active);
  error_objects_.set_bus_off(false);
  communication_.lead_frames();
  runner_.take_over_period();
  take_over_parameters();
  node_.start(now());
  runner_.show_messages();
  if (!is_back) return;
  communication_.on_bus_back();
  runner_.show_messages();
}

void CanopenFace::before_cycles() noexcept {
  reception_.on_time(now());
  if (communication_.restart_at() <= now()) try_bus_restart();
}

void CanopenFace::after_cycles() noexcept {
  node_.on_time(now());
  follow_up_all();
}

void CanopenFace::on_written(std::uint8_t object, std::uint16_t number) noexcept {
  runner_.on_parameter_written(object, number);
  if (runner_.is_saving()) node_.defer_answer();
}

bool CanopenFace::follow_up() noexcept {
  using Work = void (CanopenFace::*)(std::uint8_t) noexcept;
  static constexpr std::array<Work, static_cast<std::size_t>(BusFollowUp::Count)> kWork{
      &CanopenFace::wire_mappings, &CanopenFace::plan_bus_restart, &CanopenFace::command_node};
  if (follow_ups_.is_empty()) return false;
  while (!follow_ups_.is_empty()) {
    const BusFollowUps::Item item = follow_ups_.take();
    (this->*kWork[static_cast<std::size_t>(item.what)])(item.argument);
  }
  return true;
}

void CanopenFace::wire_mappings(std::uint8_t) noexcept {
  if (process_data_.follow_changed_mappings()) runner_.wake();
}

void CanopenFace::plan_bus_restart(std::uint8_t asked) noexcept {
  communication_.plan_restart(now(), asked != 0);
}

void CanopenFace::command_node(std::uint8_t command) noexcept {
  node_.command(static_cast<canopen::NmtCommand>(command), now());
}

/// 0 written to 1003h:00.
canopen::Result<void> CanopenFace::write(const canopen::Entry&, std::int64_t value) {
  if (value != 0) return canopen::refuse(canopen::AbortCode::InvalidValue);
  runner_.acknowledge();
  return {};
}

}  // namespace device
