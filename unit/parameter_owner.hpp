#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "drive/object/drive_object.hpp"

namespace unit {

/// One index of a parameter of a drive object.
struct ParameterPlace {
  const drive::DriveObject& object;
  const drive::ParameterRow& row;
  std::size_t index;
};

/// Answers for parameters whose home is outside the drive unit, that is, agreed parameters and commands.
class ParameterOwner {
 public:
  virtual ~ParameterOwner() = default;
  /// What @p place reads as, in the parameter's own unit; nothing: the value that was last written or loaded.
  virtual std::optional<double> value_of(const ParameterPlace& place) const noexcept {
    (void)place;
    return std::nullopt;
  }
  /// Whether the value of @p place lives with the owner: what is loaded gets there with Face::adopt().
  virtual bool is_home_of(const ParameterPlace& place) const noexcept {
    (void)place;
    return false;
  }
  /// Takes @p value, which has passed type, limits and state, or carries the command out; the reason if it cannot.
  virtual std::optional<drive::Refusal> take(const ParameterPlace& place, double value) noexcept {
    (void)place, (void)value;
    return {};
  }
};

/// Holds parameters against everybody else's writes.
class ParameterLock {
 public:
  virtual ~ParameterLock() = default;
  /// Whether index @p index of parameter @p number of @p object is held.
  virtual bool holds(const drive::DriveObject& object, std::uint16_t number, std::size_t index) const noexcept = 0;
};

}  // namespace unit
