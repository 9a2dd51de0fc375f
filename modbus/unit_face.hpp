#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "modbus/record_mailbox.hpp"
#include "unit/face.hpp"
#include "unit/runner.hpp"

namespace modbus {

/// The part of Modbus that goes with the cycles of the unit: records of the mailbox run in the first whole cycle
/// after their activation, and a p0978[0] that is no axis is shown by A08555.
class UnitFace final : public unit::Face {
 public:
  /// To be attached to @p runner, which outlives this.
  explicit UnitFace(unit::Runner& runner) noexcept : runner_{runner} {}

  /// The axis that the registers belong to (p0978[0]), or nullptr if that is none.
  const drive::DriveObject* target() const noexcept;
  const RecordMailbox& mailbox() const noexcept { return mailbox_; }
  /// Writes registers of the mailbox from @p first on.
  void write_mailbox(std::size_t first, std::span<const std::uint16_t> values) noexcept;

  // unit::Face
  void bring() noexcept override {}
  unit::AxisMask waiting() const noexcept override { return mailbox_.is_pending() ? unit::kAllAxes : 0; }
  void show() noexcept override;
  void on_cycles_over() noexcept override;

 private:
  bool shows_alarm() const noexcept;

  unit::Runner& runner_;
  RecordMailbox mailbox_;
  unit::TimePoint activated_{};
  bool has_alarm_ = false;
};

}  // namespace modbus
