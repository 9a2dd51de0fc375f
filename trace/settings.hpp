#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drive/sequence_control/state_machine.hpp"
#include "trace/frame.hpp"
#include "trace/signal/place.hpp"
#include "unit/time.hpp"

namespace trace {

inline constexpr std::size_t kMostSignals = 8;
/// Values that a trace keeps at most, of all signals and all results.
inline constexpr std::size_t kMostValues = std::size_t{1} << 20;
inline constexpr std::size_t kMostKept = 16;
/// Shortest time between two samples.
inline constexpr unit::Duration kStep = std::chrono::microseconds{125};
/// Stands for Settings::every: the end of each process-data cycle.
inline constexpr unit::Duration kEveryCycle{0};

/// What a trace begins with.
enum class TriggerKind : std::uint8_t {
  None,
  Stop,
  Rising,
  Falling,
  Above,
  Below,
  Inside,
  Outside,
  Bits,
  Fault,
  Alarm,
  State,
  Frame,
};

/// Frames that a trigger waits for: those that equal these where a mask has ones.
struct FramePattern {
  std::uint32_t id = 0;
  std::uint32_t id_mask = ~std::uint32_t{0};
  bool extended = false;
  std::optional<Direction> direction{};  ///< either way if not given
  std::uint8_t length = 0;               ///< data bytes that count, at least so many there are
  std::array<std::uint8_t, 8> data{};
  std::array<std::uint8_t, 8> data_mask{};
};

/// When a trace begins; which members count depends on the kind (see trigger_table.hpp).
struct TriggerSettings {
  TriggerKind kind = TriggerKind::None;
  std::string signal{};
  double level = 0.0;  ///< in the unit of the signal
  double low = 0.0;    ///< of a band
  double high = 0.0;
  std::uint32_t mask = ~std::uint32_t{0};
  std::uint32_t value = 0;
  std::optional<Place> place{};  ///< of a message or state; anywhere if not given
  std::uint16_t number = 0;      ///< of a message, 0 = any
  drive::State state = drive::State::OperationEnabled;
  FramePattern frame{};
};

/// What a trace records.
struct Settings {
  std::vector<std::string> signals;  ///< 1..kMostSignals names (see find_signal())
  unit::Duration every = kStep;      ///< a multiple of kStep, or kEveryCycle
  TriggerSettings trigger{};
  unit::Duration before{};                          ///< before the trigger
  unit::Duration length = std::chrono::seconds{1};  ///< of all, at least `before`
  std::optional<std::size_t> samples{};             ///< in place of `length`
  bool repeat = false;                              ///< waits for the trigger again when it is done
  std::size_t keep = 1;                             ///< results that are kept of a trace that repeats, the latest
};

}  // namespace trace
