#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "device/device.hpp"

namespace axisd {

/// The faults and alarms of a unit as they were looked at last, so that what has come and gone can be told.
class ActiveMessages {
 public:
  /// An active fault or alarm.
  struct Message {
    const drive::FaultRow* row;
    std::uint32_t value;
    std::uint32_t sequence;
    drive::Kind kind;
  };

  /// With what is active in @p device, which outlives this, now. Allocates.
  explicit ActiveMessages(const device::Device& device);

  /// Tells what is different now, drive object by drive object: @p tell (number of the drive object, message,
  /// whether it is there). What has left comes first, then what has come or has another value.
  template <class Tell>
  void look(Tell tell) {
    const std::uint32_t changes = device_.message_changes();
    if (std::exchange(changes_, changes) == changes) return;
    for (OfObject& seen : objects_) {
      const OfObject before = std::exchange(seen, messages_of(*device_.unit().object(seen.object)));
      compare(before, seen, tell);
    }
  }

 private:
  struct OfObject {
    std::uint8_t object = 0;
    std::array<Message, 2 * drive::FaultMemory::kCapacity> messages{};
    std::size_t count = 0;

    std::span<const Message> all() const noexcept { return {messages.data(), count}; }
    const Message* find(std::uint32_t sequence) const noexcept;
  };

  static OfObject messages_of(const drive::DriveObject& object) noexcept;

  template <class Tell>
  static void compare(const OfObject& before, const OfObject& after, Tell& tell) {
    for (const Message& message : before.all())
      if (after.find(message.sequence) == nullptr) tell(before.object, message, false);
    for (const Message& message : after.all()) {
      const Message* const known = before.find(message.sequence);
      if (known == nullptr || known->value != message.value) tell(after.object, message, true);
    }
  }

  const device::Device& device_;
  std::uint32_t changes_;
  std::vector<OfObject> objects_;
};

}  // namespace axisd
