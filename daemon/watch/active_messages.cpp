#include "daemon/watch/active_messages.hpp"

namespace axisd {

ActiveMessages::ActiveMessages(const device::Device& device)
    : device_{device}, changes_{device.message_changes()} {
  device.unit().for_each_object(
      [this](const drive::DriveObject& object) { objects_.push_back(messages_of(object)); });
}

const ActiveMessages::Message* ActiveMessages::OfObject::find(std::uint32_t sequence) const noexcept {
  const auto found = std::ranges::find(all(), sequence, &Message::sequence);
  return found != all().end() ? &*found : nullptr;
}

ActiveMessages::OfObject ActiveMessages::messages_of(const drive::DriveObject& object) noexcept {
  OfObject seen{.object = object.number()};
  for (const auto entries : {object.messages().faults(), object.messages().alarms()})
    for (const drive::FaultEntry& entry : entries)
      seen.messages[seen.count++] = {entry.row, entry.value, entry.sequence, entry.kind};
  return seen;
}

}  // namespace axisd
