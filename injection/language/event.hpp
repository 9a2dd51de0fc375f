#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace injection {

/// What happens on a bus or in a unit, and can be counted.
enum class EventKind : std::uint8_t {
  Frame,  ///< any frame; the kinds that follow are frames too, but Cycle
  SdoRequest,
  SdoResponse,
  Rpdo,
  Tpdo,
  Sync,
  Nmt,
  Time,
  Heartbeat,
  Guard,  ///< a request of node guarding or its answer
  Emcy,
  BootUp,
  Cycle,  ///< a process-data cycle begins; no frame
};

/// The words for them, in their order.
inline constexpr auto kEventNames =
    std::to_array<std::string_view>({"frame", "sdo-request", "sdo-response", "rpdo", "tpdo", "sync", "nmt", "time",
                                     "heartbeat", "guard", "emcy", "boot-up", "cycle"});

/// Something that has happened.
struct Occurrence {
  EventKind kind = EventKind::Frame;
  std::uint32_t identifier = 0;  ///< of the frame
};

/// What is waited for or counted: an event of a kind; of frames, those of one identifier.
struct Event {
  EventKind kind = EventKind::Frame;
  std::optional<std::uint32_t> identifier{};

  constexpr bool matches(const Occurrence& occurrence) const noexcept {
    if (kind != EventKind::Frame) return kind == occurrence.kind;
    return occurrence.kind != EventKind::Cycle &&
           identifier.value_or(occurrence.identifier) == occurrence.identifier;
  }
  friend constexpr bool operator==(const Event&, const Event&) = default;
};

/// So many of them.
struct Milestone {
  std::uint32_t count = 1;
  Event event{};

  friend constexpr bool operator==(const Milestone&, const Milestone&) = default;
};

/// "sync", "frame 185": the event that @p text names; nothing if it names none.
std::optional<Event> parse_event(std::string_view text) noexcept;
std::string text_of(const Event& event);
/// "10 heartbeat": at least one.
std::optional<Milestone> parse_milestone(std::string_view text) noexcept;
std::string text_of(const Milestone& milestone);

/// What parse_event() expects, for messages.
std::string event_rule();

}  // namespace injection
