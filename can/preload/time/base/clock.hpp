#pragma once

#include <atomic>
#include <cstdint>
#include <ctime>

#include "can/userbus/time.hpp"

namespace preload {

/// By what the clocks of this process go.
enum class Pace : uint8_t {
  Machine,  ///< nothing is changed
  Scaled,   ///< the machine's clock, so many times as quick, from some instant on
  Turns,    ///< the bus's: they stand still while the program computes
};

/// Read by every wrapped call; written by begin and when the hub has gone.
inline std::atomic<Pace> pace{Pace::Machine};

inline bool by_machine() noexcept {
  return pace.load(std::memory_order_relaxed) == Pace::Machine;
}
inline bool by_turns() noexcept {
  return pace.load(std::memory_order_relaxed) == Pace::Turns;
}

/// From now on the clocks go by @p scale from @p begin_ns on, which the bus's clock shows when the machine's
/// CLOCK_MONOTONIC shows @p machine_begin_ns.
void go_scaled(double scale, int64_t begin_ns, int64_t machine_begin_ns, int64_t wall_offset_ns) noexcept;
/// From now on they show what show_present() has said.
void go_by_turns(int64_t wall_offset_ns) noexcept;
void show_present(int64_t instant) noexcept;

/// The bus's CLOCK_MONOTONIC (ns), as this process sees it.
int64_t present() noexcept;
/// The bus's CLOCK_REALTIME at @p instant of its CLOCK_MONOTONIC.
int64_t wall_time(int64_t instant) noexcept;

/// Whether @p clock shows the bus's time; @p offset is what it shows more than the bus's CLOCK_MONOTONIC.
bool is_of_bus(clockid_t clock, int64_t& offset) noexcept;

/// The machine's CLOCK_MONOTONIC (ns).
int64_t machine_present() noexcept;
/// How long the machine takes for @p duration of the bus; for Pace::Scaled.
int64_t machine_duration(int64_t duration) noexcept;
/// How long the machine takes until the bus shows @p deadline; 0 if that has passed.
int64_t machine_left(int64_t deadline) noexcept;
/// When the machine's CLOCK_MONOTONIC shows what the bus shows as @p instant. For Pace::Turns, where a wait cannot
/// be by turns: so far from now as the bus has it.
int64_t machine_instant(int64_t instant) noexcept;

}  // namespace preload
