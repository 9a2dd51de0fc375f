#pragma once

#include <cstddef>
#include <cstdint>

#include <tl/expected.hpp>

#include "drive/drive_unit.hpp"

namespace drive {

/// What an access to a parameter leads to outside the drive unit.
class AccessListener {
 public:
  virtual ~AccessListener() = default;
  /// Whether nothing may be written now (a save runs).
  virtual bool is_locked() const noexcept { return false; }
  /// A parameter is about to be read or written: time is told.
  virtual void on_access() noexcept {}
  /// Parameter @p number of drive object @p object was written.
  virtual void on_written(std::uint8_t object, std::uint16_t number) noexcept {
    static_cast<void>(object), static_cast<void>(number);
  }
};

/// The one way in which masters read and write parameters, whatever door they come through.
class ParameterAccess {
 public:
  /// Both outlive this.
  ParameterAccess(DriveUnit& unit, AccessListener& listener) noexcept : unit_{unit}, listener_{listener} {}

 private:
  DriveUnit& unit_;
  AccessListener& listener_;
};

}  // namespace drive
