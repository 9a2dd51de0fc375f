#pragma once

#include <cstdint>

#include "device/process_data_buffers.hpp"
#include "drive/drive_unit.hpp"

namespace device {

/// The free objects of an axis that are sent, 5810h to 581Fh and 5830h to 5837h: each shows what its connector
/// input brings, p8851 or p8861 at its place in the process data while it is mapped, p8746 or p8748 otherwise.
class FreeObjects final : public canopen::EntryOwner {
 public:
  /// Owns the objects of @p axis in @p dictionary; all arguments must outlive this.
  FreeObjects(canopen::Dictionary& dictionary, const drive::DriveUnit& unit, const drive::Axis& axis,
              const ProcessDataBuffers& buffers);

  /// The mapped ones get their values.
  void publish() noexcept;

  canopen::Result<std::int64_t> read(const canopen::Entry& entry, std::int64_t stored) override;

 private:
  std::int64_t value_of(const canopen::Entry& entry, const ProcessDataLayout::Item* place) const noexcept;

  canopen::Dictionary& dictionary_;
  const drive::DriveUnit& unit_;
  const drive::Axis& axis_;
  const ProcessDataBuffers& buffers_;
};

}  // namespace device
