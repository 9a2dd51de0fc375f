#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "device/device.hpp"
#include "injection/wire/passing.hpp"
#include "unit/face.hpp"

namespace injection {

/// Who decides which faults a cycle is hit by.
class CycleListener {
 public:
  virtual ~CycleListener() = default;
  /// A cycle begins.
  virtual void on_cycle() noexcept = 0;
};

/// The CANopen face of a unit, with faults between it and the drive: what of a controlword comes through, and what
/// is shown of the actual values. It stands in the place of that face while it is put in.
class DriveFaults final : public unit::Face {
 public:
  /// Faults of @p device, of which those in @p loaded whose was_hit is set hold; all arguments outlive this.
  DriveFaults(device::Device& device, const std::vector<Loaded>& loaded, CycleListener& listener);

  /// Puts it in the place of the face, or the face back.
  void put_in(bool in) noexcept;
  /// Other faults hold from @p now on: a rest ends, for a cycle shows what that changes.
  void run_cycles(canopen::TimePoint now) noexcept;

 private:
  // unit::Face
  void bring() noexcept override;
  unit::AxisMask waiting() const noexcept override;
  void show() noexcept override;
  void on_cycles_over() noexcept override { inner_.on_cycles_over(); }
  void show_messages(bool changed) noexcept override { inner_.show_messages(changed); }
  void adopt(const unit::Replacement& replacement) noexcept override { inner_.adopt(replacement); }
  void resume(const unit::Replacement& replacement) noexcept override { inner_.resume(replacement); }
  bool restart_unit() noexcept override { return inner_.restart_unit(); }
  void on_stored(bool kept) noexcept override { inner_.on_stored(kept); }
  bool follow_up() noexcept override { return inner_.follow_up(); }

  /// What is kept of an axis while a fault holds.
  struct Axis {
    std::vector<const canopen::Entry*> shown{};  ///< its objects of actual values
    std::vector<std::int64_t> values{};          ///< their values, empty: not frozen
    std::optional<std::uint16_t> controlword{};  ///< that stays in force
    bool is_ignoring = false;
    bool is_frozen = false;
  };

  void add_actual_values(std::size_t axis);
  device::AxisDefect defect_of(std::size_t axis) const noexcept;
  void change_controlword(std::size_t axis) noexcept;
  void set_controlword(std::size_t axis, std::uint16_t controlword) noexcept;
  void freeze(Axis& axis) noexcept;
  void change_statusword(std::size_t axis, const Loaded& fault) noexcept;

  device::Device& device_;
  const std::vector<Loaded>& loaded_;
  CycleListener& listener_;
  unit::Face& inner_;
  canopen::Dictionary& dictionary_;
  std::vector<Axis> axes_;
  bool is_in_ = false;
};

}  // namespace injection
