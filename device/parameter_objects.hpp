#pragma once

#include <cstdint>

#include "drive/axis.hpp"
#include "drive/scaling.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// The profile objects that are parameters of the axis under another number and in another unit:
/// 6007h = p8641, 605Dh = p8791, 6083h = p1120, 6084h = p1121, 6085h = p1135.
class ParameterObjects final : public canopen::EntryOwner {
 public:
  /// Owns the reading of the objects of the first axis in @p dictionary for @p axis; both must outlive this.
  ParameterObjects(canopen::Dictionary& dictionary, drive::Axis& axis, const drive::BusScaling& scaling);

  canopen::Result<std::int64_t> read(const canopen::Entry& entry, std::int64_t stored) override;
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;

  /// True if object @p index is one of these.
  static bool contains(std::uint16_t index) noexcept;
  /// Gives the writing of all of them to @p owner, which hands them on to write().
  static void own_writes(canopen::Dictionary& dictionary, canopen::EntryOwner& owner);

 private:
  drive::Axis& axis_;
  drive::BusScaling scaling_;
};

}  // namespace device
