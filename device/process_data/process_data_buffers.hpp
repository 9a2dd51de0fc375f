#pragma once

#include <cstdint>
#include <optional>

#include "device/pdo/process_data_layout.hpp"
#include "drive/drive_unit.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// Where the mapped objects of one axis lie in its process data (PZD), as its parameters show it (r8750, r8751,
/// r8760, r8761), and which words are connected (r8867).
class ProcessDataBuffers {
 public:
  /// Shows the objects of @p axis in @p dictionary; all arguments must outlive this.
  ProcessDataBuffers(const canopen::Dictionary& dictionary, const drive::DriveUnit& unit,
                     const drive::Axis& axis) noexcept
      : dictionary_{dictionary}, unit_{unit}, axis_{axis} {}

  /// A mapping has changed or is about to: places are found anew when they are next asked for.
  void invalidate() noexcept {
    valid_ = false;
    ++version_;
  }
  /// Counts how often the places may have changed; never 0.
  std::uint32_t version() const noexcept { return version_; }
  /// Where received and sent objects lie.
  const ProcessDataLayout& received() const noexcept { return layouts().received; }
  const ProcessDataLayout& sent() const noexcept { return layouts().sent; }

  /// Index @p index of parameter @p number of the axis, if it is one of these.
  std::optional<double> value_of(std::uint16_t number, std::size_t index) const noexcept;

 private:
  struct Layouts {
    ProcessDataLayout received, sent;
  };
  const Layouts& layouts() const noexcept;

  const canopen::Dictionary& dictionary_;
  const drive::DriveUnit& unit_;
  const drive::Axis& axis_;
  mutable Layouts layouts_{};
  mutable bool valid_ = false;
  std::uint32_t version_ = 1;
};

}  // namespace device
