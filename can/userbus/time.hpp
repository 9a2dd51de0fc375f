#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "can/userbus/join.hpp"

/// The time of a bus that has one of its own (docs/explanation/bus-time.md): `canhub --time`.
///
/// In virtual and stepped time every program that lives by the bus's clock is a member of kind Clock beside the
/// members that send and receive for it, and says until when it has nothing to do. One program acts at a time, in
/// the order of joining; when all wait, time goes on to the earliest that is waited for, or to the next event of
/// the bus itself. Times are those of the bus's CLOCK_MONOTONIC (ns).
namespace userbus {

/// Whose time the bus has.
enum class TimeMode : uint32_t {
  Real,     ///< the machine's
  Scaled,   ///< the machine's, so many times as quick
  Virtual,  ///< that of what happens: it goes on at once when all wait
  Stepped,  ///< likewise, but only as far as Operation::Step has let it
};

/// As users write them.
inline constexpr const char* kTimeNames[] = {"real", "scaled", "virtual", "stepped"};

/// What is asked for with --time and $CAN_TIME.
struct TimeWish {
  TimeMode mode;
  double scale;  ///< of TimeMode::Scaled, else 1
};
/// Limits of the scale.
inline constexpr double kSlowestScale = 0.001, kQuickestScale = 1000;
/// What a message says is expected where read_time() is false.
inline constexpr char kTimeRule[] = "real, scaled=K (0.001 to 1000), virtual or stepped";

/// Reads @p size characters at @p text; false if they are none of kTimeRule.
bool read_time(const char* text, size_t size, TimeWish& wish) noexcept;

/// What the memory of Operation::Time holds, for reading only.
struct TimePage {
  TimeMode mode;
  uint32_t reserved = 0;
  double scale;                 ///< of TimeMode::Scaled
  int64_t begin_ns;             ///< what the bus's clock showed when it began
  int64_t machine_begin_ns;     ///< what the machine's CLOCK_MONOTONIC showed then
  int64_t wall_offset_ns;       ///< the bus's CLOCK_REALTIME less its CLOCK_MONOTONIC
  std::atomic<int64_t> now_ns;  ///< the present of virtual and stepped time
};
inline constexpr size_t kTimePageSize = 4096;
static_assert(sizeof(TimePage) <= kTimePageSize && std::atomic<int64_t>::is_always_lock_free);

/// What the clock of virtual and stepped time shows at first: always the same, so that runs can be compared.
inline constexpr int64_t kFirstInstant = 1'000'000'000'000;  // 1000 s after the start of the machine that it plays
/// CLOCK_REALTIME then: 1 January 2025, 0:00 UTC (ns).
inline constexpr int64_t kFirstWallTime = 1'735'689'600'000'000'000;
/// Somebody who waits for no instant.
inline constexpr int64_t kNoInstant = INT64_MAX;
/// Nobody waits longer (146 years): later is the same as never. What is on the bus then still has an end, and
/// CLOCK_REALTIME a number.
inline constexpr int64_t kLastInstant = INT64_MAX / 2;

/// What a member of kind Clock says. Of who is silent for kSilence while it acts, the bus goes on without it.
struct TimeMessage {
  enum class Word : uint32_t {
    Join,  ///< the first: `process` is the member; from now on it is owed a turn
    Wait,  ///< it has nothing to do before `until_ns`; ends its turn
    Want,  ///< something outside of the bus has happened to it while it waited: it is owed a turn
  };
  Word word = Word::Join;
  uint32_t flags = 0;    ///< of Join: kDevice; of Wait: kTouched
  int64_t now_ns = 0;    ///< of Wait: its present, in the horizon of its turn
  int64_t until_ns = 0;  ///< of Wait: kNoInstant = until something happens
  int32_t process = 0;   ///< of Join
  int32_t reserved = 0;
};
static_assert(sizeof(TimeMessage) == 32);

/// In TimeMessage::flags of Join: time stands while only such wait; a drive lives for its master.
inline constexpr uint32_t kDevice = 1;
/// Of Wait: others may find something that is not on the bus (a pipe, a socket, a process that has ended).
inline constexpr uint32_t kTouched = 1;
/// Of Wait: the member is about to close the connection, and its process goes on without the bus's time.
inline constexpr uint32_t kLeaves = 2;

/// A turn: what the hub says to a member of kind Clock.
struct TimeTurn {
  int64_t now_ns = 0;  ///< the present
  /// The member may go on by itself up to here, as long as it has sent and touched nothing.
  int64_t horizon_ns = 0;
  uint32_t flags = 0;      ///< kChildEnded
  uint32_t processor = 0;  ///< where the hub runs, and would have the member woken, plus 1; 0: anywhere
};
static_assert(sizeof(TimeTurn) == 24);

/// In TimeTurn::flags: a process that this one has started has ended since the last turn.
inline constexpr uint32_t kChildEnded = 1;

/// How long the bus waits for a member that acts and says nothing (ms of the machine's time).
inline constexpr int kSilence = 10'000;

/// Outcome of join_clock(): a descriptor of kind Clock, or -1 and the reason.
struct JoinedClock {
  int descriptor;
  JoinError error;
};

/// Value of Operation::Time that asks for a TimeState as payload of the reply.
inline constexpr int kAskState = 1;

/// Who is waited for in virtual and stepped time.
struct TimeState {
  int32_t acting;   ///< process that has its turn, 0 = none
  uint32_t stands;  ///< 1: time does not go on by itself, as no program is there but devices, or nobody steps
};

/// Becomes a member of kind Clock of the bus at @p path, which is served as by join() and with the time of
/// $CAN_TIME where it is started; @p flags: kDevice, @p process: whose time it is. The descriptor is closed on
/// exec unless @p inherited. It is owed a turn: take_turn() waits for it.
JoinedClock join_clock(const Path& path, const char* hub, uint32_t flags, int process, bool inherited) noexcept;

/// What the process was given by that which it was before exec, or which started it: a descriptor of kind Clock,
/// open as long as that is not closed; others are closed. -1: there is none.
int inherited_clock() noexcept;

/// Maps the page of the bus that @p descriptor, a member of any kind, belongs to; nullptr if that has the
/// machine's time, or with errno if it does not answer.
const TimePage* map_time(int descriptor) noexcept;

/// Gives back what map_time() gave.
void unmap_time(const TimePage* page) noexcept;

/// Tells the hub; false with errno if it has gone.
bool tell_time(int descriptor, const TimeMessage& message) noexcept;

/// What take_turn() came to; Gone: the hub.
enum class TurnOutcome : uint8_t { Turn, None, Gone };

/// Takes the turn that has come, or waits for it.
TurnOutcome take_turn(int descriptor, bool waits, TimeTurn& turn) noexcept;

}  // namespace userbus
