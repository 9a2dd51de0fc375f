#pragma once

#include <cstddef>

#include "cia402/axis/axis.hpp"
#include "cia402/objects/acting.hpp"
#include "cia402/objects/axis_values.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace cia402 {

/// Who makes objects act that were written over SDO.
class WriteListener {
 public:
  virtual ~WriteListener() = default;
  /// The objects @p what of @p axis (0..axes-1) have been written.
  virtual void on_acting(std::size_t axis, ActingSet what) noexcept = 0;
};

/// An axis behind its objects: what of them acts when a master writes it over SDO, and what is refused.
class AxisObjects final : private canopen::EntryOwner {
 public:
  /// Of axis @p number (1..8) in @p dictionary, whose drive does what @p setup says; all but that outlive this.
  AxisObjects(std::size_t number, canopen::Dictionary& dictionary, const AxisSetup& setup, AxisListener& faults,
              WriteListener& writes);
  ~AxisObjects() override = default;
  AxisObjects(const AxisObjects&) = delete;
  AxisObjects& operator=(const AxisObjects&) = delete;

  Axis& axis() noexcept { return axis_; }
  const Axis& axis() const noexcept { return axis_; }
  const AxisValues& values() const noexcept { return values_; }

 private:
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;

  std::size_t number_;
  canopen::Dictionary& dictionary_;
  WriteListener& writes_;
  AxisValues values_;
  Axis axis_;
};

}  // namespace cia402
