#pragma once

#include <cstdint>
#include <optional>

#include "device/parameters/parameter_objects.hpp"
#include "device/process_data/process_data.hpp"
#include "device/process_data/written_controlwords.hpp"
#include "drive/axis/axis.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "unit/runner.hpp"

namespace device {

/// One axis behind its objects: what a master writes moves it, what it does is shown.
class AxisObjects final : private canopen::EntryOwner, private ParameterListener {
 public:
  /// Owns the objects of @p axis in @p dictionary, whose mapped ones lie at @p places; the axis is one of @p
  /// runner, which is told when something comes. All arguments must outlive this.
  AxisObjects(canopen::Dictionary& dictionary, drive::Axis& axis, const ProcessDataBuffers& places,
              unit::Runner& runner);
  ~AxisObjects() override = default;
  AxisObjects(const AxisObjects&) = delete;
  AxisObjects& operator=(const AxisObjects&) = delete;

  /// Brings what was received to the axis for a cycle; of controlwords that came over SDO each takes one.
  void receive() noexcept;
  /// Whether controlwords wait for further cycles.
  bool is_waiting() const noexcept { return !written_controlwords_.is_empty(); }
  /// Shows what the axis does.
  void publish() noexcept { process_data_.publish(); }
  /// An RPDO of the axis has been stored.
  void on_rpdo() noexcept;
  /// Controlwords that wait for a cycle are void.
  void forget_written() noexcept { written_controlwords_.clear(); }

 private:
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;
  canopen::Result<std::int64_t> read(const canopen::Entry& entry, std::int64_t stored) override;
  /// Something has come: the next cycle has to run.
  void wake() noexcept { runner_.wake(mask_); }
  bool is_placed(const canopen::Entry& entry) const noexcept;
  void on_parameter_written(const drive::Axis&) noexcept override { wake(); }

  drive::Axis& axis_;
  const ProcessDataBuffers& places_;
  unit::Runner& runner_;
  unit::AxisMask mask_;  ///< of the axis
  ProcessData process_data_;
  ParameterObjects parameter_objects_;
  WrittenControlwords written_controlwords_;
};

}  // namespace device
