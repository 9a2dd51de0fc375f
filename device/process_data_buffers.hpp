#pragma once

#include <cstdint>
#include <optional>

#include "device/process_data_layout.hpp"
#include "drive/drive_unit.hpp"
#include "libcanopen/node/node.hpp"

namespace device {

/// The process data (PZD) of one axis as its parameters show them: which object lies where (r8750, r8751, r8760,
/// r8761), what is received (r8850, r8860, r8890 to r8893, r8745, r8747, r8792, r8796, r8797) and sent (r8853,
/// r8863), and the state of the interface (r8843, r8867). In the words, speeds and torques are relative to p2000
/// and p2003; everything else is as it is on the bus. A double word is two words, the upper one first.
class ProcessDataBuffers {
 public:
  /// Shows the objects of @p axis in @p dictionary; all arguments must outlive this.
  ProcessDataBuffers(const canopen::Dictionary& dictionary, const drive::DriveUnit& unit, const drive::Axis& axis,
                     const canopen::Node& node) noexcept
      : dictionary_{dictionary}, unit_{unit}, axis_{axis}, node_{node} {}

  /// A mapping has changed or is about to: places are found anew when they are next asked for.
  void invalidate() noexcept { valid_ = false; }
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
  const canopen::Node& node_;
  mutable Layouts layouts_{};
  mutable bool valid_ = false;
};

}  // namespace device
