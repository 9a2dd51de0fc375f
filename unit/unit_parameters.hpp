#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drive/drive_unit.hpp"
#include "unit/parameter_owner.hpp"

namespace unit {

/// Leads the agreed parameters and the commands of the drive unit to those who answer for them; a parameter of
/// nobody is a value that is kept.
class UnitParameters final : public drive::ParameterHost {
 public:
  /// @p owner, which outlives this, answers for the parameters @p first to @p last of every drive object, in place
  /// of whom was named before. To be called before the unit is switched on.
  void answer(std::uint16_t first, std::uint16_t last, ParameterOwner& owner);
  void answer(std::uint16_t number, ParameterOwner& owner) { answer(number, number, owner); }
  /// @p lock, which outlives this, holds parameters from now on. To be called before the unit is switched on.
  void lock_by(const ParameterLock& lock) { locks_.push_back(&lock); }

  std::optional<drive::Refusal> on_parameter(const drive::DriveObject& object, const drive::ParameterRow& row,
                                             std::size_t index, double value) noexcept override;
  std::optional<double> value_of(const drive::DriveObject& object, const drive::ParameterRow& row,
                                 std::size_t index) const noexcept override;
  std::optional<drive::Refusal> lock_on(const drive::DriveObject& object, const drive::ParameterRow& row,
                                        std::size_t index) const noexcept override;

  /// Whether the value of @p place lives with who answers for it.
  bool is_elsewhere(const ParameterPlace& place) const noexcept;

 private:
  struct Range {
    std::uint16_t first, last;
    ParameterOwner* owner;
  };
  ParameterOwner* owner_of(std::uint16_t number) const noexcept;

  std::vector<Range> ranges_;  ///< apart from each other, ascending
  std::vector<const ParameterLock*> locks_;
};

}  // namespace unit
