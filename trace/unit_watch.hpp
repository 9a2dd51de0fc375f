#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "drive/drive_unit.hpp"
#include "trace/event.hpp"

namespace trace {

/// Sees drive states that have changed, and faults and alarms that have come or gone, by comparing them with those
/// of the last look. Nothing is allocated after construction.
class UnitWatch {
 public:
  /// What is there already is nothing new. @p unit outlives this.
  explicit UnitWatch(const drive::DriveUnit& unit);

  /// Calls @p tell with an Event for all that has changed by @p now.
  template <class Tell>
  void look(unit::TimePoint now, const Tell& tell) noexcept {
    for (Seen& seen : seen_) {
      Seen present = look_at(*seen.object);
      if (present.state != seen.state)
        tell(Event{
            .time = now, .kind = event_kind::kDriveState, .place = seen.place, .text = name_of(*present.state)});
      if (present.changes != seen.changes) compare(seen, present, now, tell);
      seen = present;
    }
  }

 private:
  struct Message {
    const drive::FaultRow* row = nullptr;
    std::uint32_t sequence = 0;
    drive::Kind kind = drive::Kind::Fault;
  };
  struct Seen {
    const drive::DriveObject* object = nullptr;
    Place place = kControlUnitPlace;
    std::optional<drive::State> state{};
    std::uint32_t changes = 0;
    std::array<Message, 2 * drive::FaultMemory::kCapacity> messages{};
    std::size_t count = 0;

    bool has(const Message& wanted) const noexcept;
  };

  Seen look_at(const drive::DriveObject& object) const noexcept;
  std::optional<drive::State> state_of(Place place) const noexcept;

  template <class Tell>
  static void compare(const Seen& before, const Seen& present, unit::TimePoint now, const Tell& tell) noexcept {
    const auto tell_of = [&](const Seen& from, const Seen& other, bool active) {
      for (std::size_t i = 0; i < from.count; ++i) {
        const Message& message = from.messages[i];
        if (other.has(message)) continue;
        tell(Event{.time = now,
                   .kind = message.kind == drive::Kind::Fault ? event_kind::kFault : event_kind::kAlarm,
                   .place = from.place,
                   .active = active,
                   .number = message.row->number,
                   .text = message.row->name});
      }
    };
    tell_of(before, present, false);
    tell_of(present, before, true);
  }

  const drive::DriveUnit& unit_;
  std::vector<Seen> seen_;  ///< one a drive object
};

}  // namespace trace
