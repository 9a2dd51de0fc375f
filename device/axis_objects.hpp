#pragma once

#include <cstdint>
#include <optional>

#include "device/parameter_objects.hpp"
#include "device/process_data.hpp"
#include "device/written_controlwords.hpp"
#include "drive/axis.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// Who runs the cycles of an axis.
class AxisListener {
 public:
  virtual ~AxisListener() = default;
  /// An axis that was idle has to be moved again.
  virtual void on_awake() noexcept = 0;
};

/// One axis behind its objects: what a master writes moves it, what it does is shown.
class AxisObjects final : private canopen::EntryOwner, private ParameterListener {
 public:
  /// Owns the objects of @p axis in @p dictionary; all arguments must outlive this.
  AxisObjects(canopen::Dictionary& dictionary, drive::Axis& axis, AxisListener& listener);
  ~AxisObjects() override = default;
  AxisObjects(const AxisObjects&) = delete;
  AxisObjects& operator=(const AxisObjects&) = delete;

  /// What the next cycle is to be run with, nothing while idle; of controlwords that came over SDO each takes one.
  std::optional<drive::Setpoints> take_setpoints() noexcept;
  /// Cycles have been run: sees whether the axis has become idle.
  void end_cycles() noexcept;
  /// Shows what the axis does.
  void publish() noexcept { process_data_.publish(axis_.actual()); }
  /// Nothing moves, and nothing has come since the last cycle that could change that.
  bool is_idle() const noexcept { return idle_; }
  /// Something has come: the next cycle has to run.
  void wake() noexcept;
  /// An RPDO of the axis has been stored.
  void on_rpdo() noexcept;
  /// Controlwords that wait for a cycle are void.
  void forget_written() noexcept { written_controlwords_.clear(); }

  /// What the axis is asked for at present.
  drive::Setpoints setpoints() const noexcept { return process_data_.setpoints(); }

 private:
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;
  void on_parameter_written(const drive::Axis&) noexcept override { wake(); }

  drive::Axis& axis_;
  AxisListener& listener_;
  ProcessData process_data_;
  ParameterObjects parameter_objects_;
  WrittenControlwords written_controlwords_;
  bool idle_ = true;
};

}  // namespace device
