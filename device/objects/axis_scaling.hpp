#pragma once

#include <cstdint>

#include "device/objects/object_index.hpp"
#include "drive/axis/axis.hpp"
#include "drive/base/scaling.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// The scaling of the objects of an axis: its encoder and rated torque, and the factor that 6094h holds now.
class AxisScaling {
 public:
  /// Of @p axis, with its 6094h in @p dictionary; both outlive this.
  AxisScaling(canopen::Dictionary& dictionary, const drive::Axis& axis)
      : axis_{axis},
        numerator_{dictionary.cell<std::uint32_t>(index_of(axis), 1)},
        denominator_{dictionary.cell<std::uint32_t>(index_of(axis), 2)} {}

  drive::BusScaling get() const noexcept {
    const drive::SpeedFactor factor{static_cast<double>(numerator_.get()),
                                    static_cast<double>(denominator_.get())};
    return drive::BusScaling{axis_.references(), factor, axis_.has_encoder()};
  }

 private:
  static std::uint16_t index_of(const drive::Axis& axis) noexcept {
    return object::on_axis(object::kVelocityFactor, axis.axis_number());
  }

  const drive::Axis& axis_;
  canopen::Cell<std::uint32_t> numerator_;
  canopen::Cell<std::uint32_t> denominator_;
};

}  // namespace device
