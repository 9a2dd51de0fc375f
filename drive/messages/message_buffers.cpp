#include "drive/messages/message_buffers.hpp"

namespace drive {

void AlarmBuffer::enter(std::uint16_t number, std::uint32_t value, const TimeStamp& now) noexcept {
  if (current_ == kCurrent) archive();
  if (current_ == kCurrent) return;
  entries_[current_++] = Entry{{number, value, now, {}}, true};
}

void AlarmBuffer::change(std::uint16_t number, std::uint32_t value) noexcept {
  if (Entry* const entry = find_active(number)) entry->shown.value = value;
}

void AlarmBuffer::leave(std::uint16_t number, const TimeStamp& now) noexcept {
  Entry* const entry = find_active(number);
  if (entry == nullptr) return;
  entry->active = false;
  entry->shown.removed = now;
}

void AlarmBuffer::clear() noexcept {
  Entry* const end = entries_.data() + current_;
  Entry* const kept = std::stable_partition(entries_.data(), end, [](const Entry& entry) { return entry.active; });
  current_ = static_cast<std::size_t>(kept - entries_.data());
  std::fill(entries_.begin() + static_cast<std::ptrdiff_t>(current_), entries_.end(), Entry{});
}

AlarmBuffer::Entry* AlarmBuffer::find_active(std::uint16_t number) noexcept {
  Entry* const end = entries_.data() + current_;
  Entry* const found = std::find_if(
      entries_.data(), end, [=](const Entry& entry) { return entry.active && entry.shown.number == number; });
  return found != end ? found : nullptr;
}

/// Moves the alarms that are gone from the current places to the front of the history.
void AlarmBuffer::archive() noexcept {
  std::array<Entry, kCurrent> active{};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < current_; ++i) {
    if (entries_[i].active) {
      active[kept++] = entries_[i];
      continue;
    }
    std::move_backward(entries_.begin() + kCurrent, entries_.end() - 1, entries_.end());
    entries_[kCurrent] = entries_[i];
  }
  std::copy(active.begin(), active.end(), entries_.begin());
  current_ = kept;
}

}  // namespace drive
