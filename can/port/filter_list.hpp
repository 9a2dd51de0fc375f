#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <linux/can.h>
#include <linux/can/raw.h>

#include "can/port/port.hpp"

namespace bus {

/// The filters of a port in SocketCAN's form; at first they let every frame pass.
class FilterList {
 public:
  /// Takes @p filters; more than CAN_RAW_FILTER_MAX (512) of them stand for every frame.
  void assign(std::span<const Filter> filters) noexcept;
  [[nodiscard]] std::span<const can_filter> get() const noexcept { return std::span{filters_}.first(count_); }
  /// True if @p frame matches one of them: for a bus that does not filter itself.
  [[nodiscard]] bool pass(const canopen::Frame& frame) const noexcept;

 private:
  std::array<can_filter, CAN_RAW_FILTER_MAX> filters_{};  // the first one is can_filter{0, 0}: every frame
  std::size_t count_ = 1;
};

}  // namespace bus
