#pragma once

#include <cstdint>

#include "device/objects/axis_scaling.hpp"
#include "drive/axis/axis.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// Who is told when a parameter was written: an axis that rests has to be moved again.
class ParameterListener {
 public:
  virtual ~ParameterListener() = default;
  /// A parameter of @p axis has a new value.
  virtual void on_parameter_written(const drive::Axis& axis) noexcept = 0;
};

/// The profile objects that are parameters of the axis under another number and in another unit
/// (kObjectParameters). 6072h is p1521 too, and 6086h sets p1134 with p1115.
class ParameterObjects final : public canopen::EntryOwner {
 public:
  /// Owns the objects of @p axis in @p dictionary; all arguments must outlive this.
  ParameterObjects(canopen::Dictionary& dictionary, drive::Axis& axis, ParameterListener& listener);

  canopen::Result<std::int64_t> read(const canopen::Entry& entry, std::int64_t stored) override;
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;

 private:
  tl::expected<void, drive::ParameterError> write_torque_limits(double torque) noexcept;
  canopen::Result<double> parameter_value(const canopen::Entry& entry, std::int64_t value) const;

  drive::Axis& axis_;
  ParameterListener& listener_;
  AxisScaling scaling_;
};

}  // namespace device
