#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cia402/objects/acting.hpp"
#include "drive/base/object_kind.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "libcanopen/pdo/settings.hpp"

namespace cia402 {

/// What was received of each axis and has not acted yet. All objects of an RPDO, or of all RPDOs of a SYNC, are
/// written before any of them acts.
using AxisActions = std::array<ActingSet, drive::kMostAxes>;

/// What each RPDO of a node brings, compiled from its mapping.
class RpdoActions {
 public:
  /// Of the @p pdos of @p dictionary as they are now.
  void compile(const canopen::Dictionary& dictionary, std::span<const canopen::PdoSettings> pdos) noexcept;
  /// Room for @p pdos PDOs.
  explicit RpdoActions(std::size_t pdos) : rows_(pdos) {}

  /// What RPDO @p number (0 for 1400h) brings.
  const AxisActions& of(std::uint16_t number) const noexcept { return row(number).actions; }
  /// Whether it waits for a SYNC.
  bool is_synchronous(std::uint16_t number) const noexcept { return row(number).synchronous; }
  /// What RPDOs in force that wait for a SYNC bring to @p axis (0..axes-1).
  ActingSet with_sync(std::size_t axis) const noexcept { return with_sync_[axis]; }

 private:
  struct Row {
    std::uint16_t number = 0;
    bool synchronous = false;
    AxisActions actions{};
  };
  const Row& row(std::uint16_t number) const noexcept;

  std::vector<Row> rows_;
  AxisActions with_sync_{};
};

}  // namespace cia402
