#pragma once

#include <vector>

#include "tests/device/test_unit.hpp"

namespace device {

/// A unit whose window shows the control unit.
struct ControlUnit : TestUnit {
  explicit ControlUnit(std::size_t axes = 1) : TestUnit{{.node_id = 5, .axes = std::vector<AxisSetup>(axes)}} {
    start();
    open(1);
  }
  void open(std::uint16_t object) { ASSERT_EQ(download(0x41B6, 0, object, 2), 0U); }
  canopen::NmtState state() const { return device.node().state(); }
  std::vector<std::uint16_t> faults(std::uint8_t object) const {
    std::vector<std::uint16_t> numbers;
    for (const drive::FaultEntry& entry : device.unit().object(object)->messages().faults())
      numbers.push_back(entry.row->number);
    return numbers;
  }
};

using Numbers = std::vector<std::uint16_t>;

}  // namespace device
