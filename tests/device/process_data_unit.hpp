#pragma once

#include <deque>
#include <vector>

#include "device/objects/object_rows.hpp"
#include "device/process_data/process_data.hpp"
#include "device/process_data/unit_process_data.hpp"
#include "libcanopen/application/application.hpp"
#include "tests/fakes/vector_bus.hpp"

namespace device {

/// The PDO configuration and the process data of a unit, node-ID 5, without the motors and the rest of the device.
class ProcessDataUnit : private AlarmListener, private canopen::Application {
 public:
  explicit ProcessDataUnit(std::size_t axes)
      : rows{object_rows(std::vector<drive::ObjectKind>(axes, drive::ObjectKind::Servo))},
        unit{{.axes = std::vector<drive::AxisConfiguration>(axes), .node_id = 5}, &parameters} {
    for (drive::Axis& axis : unit.axes()) {
      process_data.emplace_back(dictionary, axis, unit_process_data.places(axis.axis_number()));
    }
    unit_process_data.take_over(UnitProcessData::WiredBy::Factory);
  }

  /// A cycle without the motors: what was written is received, and what is connected is sent.
  void exchange() {
    unit_process_data.follow_mappings();
    unit_process_data.show_state();
    for (ProcessData& data : process_data) data.receive(data.controlword());
    unit.exchange_process_data();
    for (ProcessData& data : process_data) data.publish();
  }

  /// Writes an object as a master does; 0 or the abort code.
  std::uint32_t write(std::uint16_t index, std::uint8_t sub_index, std::int64_t value) {
    const auto written = dictionary.write(**dictionary.find(index, sub_index), value);
    return written ? 0 : static_cast<std::uint32_t>(written.error());
  }
  /// Reads an object as a master does, after a cycle.
  std::int64_t read(std::uint16_t index, std::uint8_t sub_index = 0) {
    exchange();
    return dictionary.read(**dictionary.find(index, sub_index)).value();
  }
  /// Reads a parameter of a drive object (control unit 1, axes from 2), after a cycle.
  double parameter(std::uint8_t object, std::uint16_t number, std::size_t index = 0) {
    exchange();
    return unit.object(object)->read(number, index).value();
  }
  /// Writes one; false if it is refused.
  bool set_parameter(std::uint8_t object, std::uint16_t number, std::size_t index, double value) {
    return unit.object(object)->write(number, index, value).has_value();
  }
  /// Alarms of the control unit that are active.
  std::vector<std::uint16_t> alarms() const {
    std::vector<std::uint16_t> numbers;
    for (const drive::FaultEntry& alarm : unit.object(1)->messages().alarms())
      numbers.push_back(alarm.row->number);
    return numbers;
  }
  void start() { node.start(canopen::TimePoint{}); }
  void command(canopen::NmtCommand wanted) { node.command(wanted, canopen::TimePoint{}); }

  ::unit::UnitParameters parameters;
  BusFollowUps follow_ups;
  std::vector<canopen::EntryDescription> rows;
  drive::DriveUnit unit;
  canopen::Dictionary dictionary{rows, 5};
  fakes::VectorBus bus;
  canopen::Policy policy{.pdo_changes_in_operational = false, .count_follows_entries = true};
  canopen::Node node{dictionary, policy, bus, *this};
  UnitProcessData unit_process_data{dictionary, unit, node, parameters, {*this, follow_ups}};
  std::deque<ProcessData> process_data;

 private:
  void on_alarm() noexcept override {}
};

}  // namespace device
