#pragma once

#include "device/objects/object_index.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace device {

/// Keeps heartbeat (1017h) and life guarding (100Ch, 100Dh) apart: neither may be written while the other is on.
class ErrorControl final : public canopen::EntryOwner {
 public:
  /// Owns the writing of the three objects in @p dictionary, which must outlive this.
  explicit ErrorControl(canopen::Dictionary& dictionary) : dictionary_{dictionary} {
    for (const std::uint16_t index : {object::kGuardTime, object::kLifeTimeFactor, object::kHeartbeatTime})
      dictionary.own_write(index, 0, *this);
  }

  /// DeviceState for a value other than 0 while the other mechanism is on.
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override {
    const bool other_is_on = entry.index == object::kHeartbeatTime ? is_guarded() : is_on(object::kHeartbeatTime);
    if (value != 0 && other_is_on) return canopen::refuse(canopen::AbortCode::DeviceState);
    return {};
  }

 private:
  bool is_on(std::uint16_t index) const noexcept { return dictionary_.stored(index, 0).value_or(0) != 0; }
  bool is_guarded() const noexcept { return is_on(object::kGuardTime) && is_on(object::kLifeTimeFactor); }

  canopen::Dictionary& dictionary_;
};

}  // namespace device
