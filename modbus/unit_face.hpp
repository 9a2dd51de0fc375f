#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drive/access/parameter_access.hpp"
#include "modbus/record_mailbox.hpp"
#include "unit/face.hpp"
#include "unit/runner.hpp"

namespace modbus {

/// What carries a record out: see profidrive::record::answer().
using RecordAnswer = std::size_t (*)(std::span<const std::uint8_t> request,
                                     std::span<std::uint8_t, RecordMailbox::kMostBytes> response,
                                     drive::ParameterAccess& access) noexcept;

/// The part of Modbus that goes with the cycles of the unit: records of the mailbox run in the first whole cycle
/// after their activation, and a p0978[0] that is no axis is shown by A08555.
class UnitFace final : public unit::Face, private drive::AccessListener {
 public:
  /// To be attached to @p runner, which outlives this.
  UnitFace(unit::Runner& runner, RecordAnswer carry_out) noexcept
      : runner_{runner}, carry_out_{carry_out}, access_{runner.unit(), *this} {}

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
  // drive::AccessListener
  bool is_locked() const noexcept override { return runner_.is_saving(); }
  void on_access() noexcept override { runner_.tell_time(); }
  void on_written(std::uint8_t object, std::uint16_t number) noexcept override {
    runner_.on_parameter_written(object, number);
  }
  bool shows_alarm() const noexcept;

  unit::Runner& runner_;
  RecordAnswer carry_out_;
  drive::ParameterAccess access_;
  RecordMailbox mailbox_;
  unit::TimePoint activated_{};
  bool has_alarm_ = false;
};

}  // namespace modbus
