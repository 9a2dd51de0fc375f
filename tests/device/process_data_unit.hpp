#pragma once

#include <deque>
#include <vector>

#include "device/free_objects.hpp"
#include "device/object_rows.hpp"
#include "device/pdo_rules.hpp"
#include "device/process_data_parameters.hpp"
#include "libcanopen/node/application.hpp"
#include "tests/fakes/vector_bus.hpp"

namespace device {

/// The PDO configuration and the process data of a unit, node-ID 5, without the motors and the rest of the device.
class ProcessDataUnit final : private MappingListener, private AlarmListener, private canopen::Application {
 public:
  explicit ProcessDataUnit(std::size_t axes)
      : rows{object_rows(std::vector<drive::ObjectKind>(axes, drive::ObjectKind::Servo))},
        unit{{.axes = std::vector<drive::AxisConfiguration>(axes), .node_id = 5}, &parameters} {
    for (drive::Axis& axis : unit.axes()) {
      buffers.emplace_back(dictionary, unit, axis, node);
      free_objects.emplace_back(dictionary, unit, axis, buffers.back());
    }
  }

  /// Writes an object as a master does; 0 or the abort code.
  std::uint32_t write(std::uint16_t index, std::uint8_t sub_index, std::int64_t value) {
    const auto written = dictionary.write(**dictionary.find(index, sub_index), value);
    return written ? 0 : static_cast<std::uint32_t>(written.error());
  }
  /// Reads an object as a master does.
  std::int64_t read(std::uint16_t index, std::uint8_t sub_index = 0) {
    return dictionary.read(**dictionary.find(index, sub_index)).value();
  }
  /// Reads a parameter of a drive object (control unit 1, axes from 2).
  double parameter(std::uint8_t object, std::uint16_t number, std::size_t index = 0) const {
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

  UnitParameters parameters;
  std::vector<canopen::EntryDescription> rows;
  drive::DriveUnit unit;
  canopen::Dictionary dictionary{rows, 5};
  fakes::VectorBus bus;
  canopen::Policy policy{.pdo_changes_in_operational = false, .count_follows_entries = true};
  canopen::Node node{dictionary, policy, bus, *this};
  PdoRules rules{dictionary, unit, node, {*this, *this}};
  std::deque<ProcessDataBuffers> buffers;
  std::deque<FreeObjects> free_objects;
  ProcessDataParameters process_data_parameters{unit, buffers, rules, parameters};

 private:
  void on_mapping_changed(std::size_t axis) noexcept override { buffers[axis - 1].invalidate(); }
  void on_alarm() noexcept override {}
};

}  // namespace device
