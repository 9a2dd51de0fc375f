#pragma once

#include <deque>

#include "device/free_objects.hpp"
#include "device/pdo_rules.hpp"
#include "device/process_data_buffers.hpp"
#include "device/process_data_parameters.hpp"

namespace device {

/// The PDO configuration and the process data of all axes behind their objects and parameters.
class UnitProcessData final : private MappingListener {
 public:
  /// Owns the PDO records and the free objects in @p dictionary and answers in @p parameters; all arguments must
  /// outlive this.
  UnitProcessData(canopen::Dictionary& dictionary, drive::DriveUnit& unit, const canopen::Node& node,
                  UnitParameters& parameters, AlarmListener& listener);
  ~UnitProcessData() override = default;
  UnitProcessData(const UnitProcessData&) = delete;
  UnitProcessData& operator=(const UnitProcessData&) = delete;

  /// The dictionary has values that no master has written: PDOs that must not be valid become invalid.
  void take_over() noexcept;
  /// Free objects that are mapped get their values; after everything that they may show.
  void publish() noexcept;
  /// The NMT state has changed.
  void end_alarms() noexcept { rules_.end_alarms(); }

 private:
  void on_mapping_changed(std::size_t axis) noexcept override { buffers_[axis - 1].invalidate(); }

  PdoRules rules_;
  std::deque<ProcessDataBuffers> buffers_;
  std::deque<FreeObjects> free_objects_;
  ProcessDataParameters parameters_;
};

}  // namespace device
