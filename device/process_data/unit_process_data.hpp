#pragma once

#include <array>
#include <cstdint>
#include <deque>

#include "device/bus/bus_follow_ups.hpp"
#include "device/pdo/pdo_rules.hpp"
#include "device/process_data/free_objects.hpp"
#include "device/process_data/process_data_buffers.hpp"
#include "device/process_data/process_data_parameters.hpp"
#include "device/process_data/standard_wiring.hpp"

namespace device {

/// The PDO configuration and the process data of all axes behind their objects and parameters.
class UnitProcessData final : private MappingListener {
 public:
  /// Who is told.
  struct Listeners {
    AlarmListener& alarm;
    BusFollowUps& follow_ups;  ///< of a mapping that has changed
  };
  /// Owns the PDO records and the free objects in @p dictionary and answers in @p parameters; all arguments must
  /// outlive this.
  UnitProcessData(canopen::Dictionary& dictionary, drive::DriveUnit& unit, const canopen::Node& node,
                  unit::UnitParameters& parameters, const Listeners& listeners);
  ~UnitProcessData() override = default;
  UnitProcessData(const UnitProcessData&) = delete;
  UnitProcessData& operator=(const UnitProcessData&) = delete;

  /// What the interconnections of the standard objects were before the dictionary got other values.
  enum class WiredBy : std::uint8_t {
    Factory,  ///< they have factory values
    Saved,    ///< they were saved together with the mappings
    Before,   ///< they are what they were
  };
  /// The dictionary has values that no master has written: PDOs that must not be valid become invalid, and the
  /// interconnections follow.
  void take_over(WiredBy wired) noexcept;
  /// What has to follow when a mapping or a mode has changed; between calls into the node, or before a cycle.
  /// Whether a mapping had.
  bool follow_mappings() noexcept;
  /// The same between cycles: only if a mapping has changed.
  bool follow_changed_mappings() noexcept { return mapping_changed_ && follow_mappings(); }
  /// r8843 follows the NMT state.
  void show_state() noexcept;
  /// The places of the process data of @p axis (from 1).
  const ProcessDataBuffers& places(std::size_t axis) const noexcept { return buffers_[axis - 1]; }
  /// The NMT state has changed.
  void end_alarms() noexcept { rules_.end_alarms(); }

 private:
  /// What the way of the speed setpoint of an axis depends on besides mappings.
  struct SetpointPath {
    std::uint16_t speed_object = 0;
    bool setpoint_channel = true;

    friend bool operator==(const SetpointPath&, const SetpointPath&) = default;
  };

  void on_mapping_changed(std::size_t axis) noexcept override {
    buffers_[axis - 1].invalidate();
    mapping_changed_ = true;
    follow_ups_.add(BusFollowUp::WireMappings);
  }

  drive::DriveUnit& unit_;
  const canopen::Node& node_;
  BusFollowUps& follow_ups_;
  PdoRules rules_;
  std::deque<ProcessDataBuffers> buffers_;
  std::deque<FreeObjects> free_objects_;
  std::deque<StandardWiring> wiring_;
  ProcessDataParameters parameters_;
  std::array<SetpointPath, drive::kMostAxes> paths_{};  ///< as the interconnections are
  bool mapping_changed_ = false;
};

}  // namespace device
