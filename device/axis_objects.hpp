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
  /// Owns the objects of @p axis in @p dictionary, whose mapped ones lie at @p places; all arguments must outlive
  /// this.
  AxisObjects(canopen::Dictionary& dictionary, drive::Axis& axis, const ProcessDataBuffers& places,
              AxisListener& listener);
  ~AxisObjects() override = default;
  AxisObjects(const AxisObjects&) = delete;
  AxisObjects& operator=(const AxisObjects&) = delete;

  /// Brings what was received to the axis for a cycle; of controlwords that came over SDO each takes one. False
  /// while idle: nothing has come.
  bool receive() noexcept;
  /// Cycles have been run: sees whether the axis has become idle.
  void end_cycles() noexcept;
  /// Shows what the axis does.
  void publish() noexcept { process_data_.publish(); }
  /// Nothing moves, and nothing has come since the last cycle that could change that.
  bool is_idle() const noexcept { return idle_; }
  /// Something has come: the next cycle has to run.
  void wake() noexcept;
  /// An RPDO of the axis has been stored.
  void on_rpdo() noexcept;
  /// Controlwords that wait for a cycle are void.
  void forget_written() noexcept { written_controlwords_.clear(); }

 private:
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;
  canopen::Result<std::int64_t> read(const canopen::Entry& entry, std::int64_t stored) override;
  bool is_placed(const canopen::Entry& entry) const noexcept;
  void on_parameter_written(const drive::Axis&) noexcept override { wake(); }

  drive::Axis& axis_;
  const ProcessDataBuffers& places_;
  AxisListener& listener_;
  ProcessData process_data_;
  ParameterObjects parameter_objects_;
  WrittenControlwords written_controlwords_;
  bool idle_ = true;
};

}  // namespace device
