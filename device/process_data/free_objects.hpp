#pragma once

#include <cstdint>

#include "device/process_data/process_data_buffers.hpp"
#include "drive/drive_unit.hpp"

namespace device {

/// The free objects of an axis that are sent, 5810h to 581Fh and 5830h to 5837h, while they have no place in the
/// process data: each shows what its connector input brings, p8746 or p8748.
class FreeObjects final : public canopen::EntryOwner {
 public:
  /// Owns the objects of @p axis in @p dictionary; all arguments must outlive this.
  FreeObjects(canopen::Dictionary& dictionary, const drive::DriveUnit& unit, const drive::Axis& axis,
              const ProcessDataBuffers& buffers);

  canopen::Result<std::int64_t> read(const canopen::Entry& entry, std::int64_t stored) override;

 private:
  const drive::DriveUnit& unit_;
  const drive::Axis& axis_;
  const ProcessDataBuffers& buffers_;
};

}  // namespace device
