#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "drive/base/input_edges.hpp"

namespace drive {

/// What is asked of a capture.
struct CaptureRequest {
  bool mark = false;          ///< p2508: the next zero mark
  bool probe = false;         ///< p2509: the next edge of a measuring probe
  bool second_probe = false;  ///< p2510: probe 2; taken when p2509 becomes 1
  bool falling_edge = false;  ///< p2511: its falling edge; taken when p2509 becomes 1
};

/// The terminals of marks and probes: n is DI n-1, 0 none.
struct CaptureTerminals {
  std::int32_t mark_selection = 0;       ///< p0493: a zero mark counts only while it is 1
  std::int32_t equivalent_mark = 0;      ///< p0494, p0495: its rising edge is the mark
  std::array<std::int32_t, 2> probes{};  ///< p0488 and p0489, or p2517 and p2518
};

/// What the encoder has done in a slice of time, in increments past the zero of its disc.
struct DiscMotion {
  std::int64_t from = 0;
  std::int64_t to = 0;
  std::int64_t per_revolution = 1;  ///< between two zero marks
};

/// The event that was waited for.
struct Captured {
  double instant = 0.0;                ///< of the slice, 0..1
  std::optional<std::int64_t> mark{};  ///< of a zero mark: where it is on the disc (increments)
};

/// Waits for a zero mark or an edge at a terminal, as p2508 and p2509 ask for.
class PositionCapture {
 public:
  /// Values of A07498.
  static constexpr std::int32_t kNoTerminal = 6;
  static constexpr std::int32_t kNotPossible = 4100;
  static constexpr std::int32_t kCyclic = 50001;  ///< more than 50000: measuring in cycles is not permitted

  /// A process-data cycle begins: a request that was taken back in the last one is told no longer.
  void begin_cycle() noexcept { withdrawn_ = false; }
  /// The event in the slice that has passed, if one was waited for and came.
  std::optional<Captured> look(const DiscMotion& motion, const InputEdges& edges) noexcept;
  /// What is asked for from now on. It is not @p possible without a valid position.
  void follow(const CaptureRequest& request, const CaptureTerminals& terminals, bool possible) noexcept;

  /// r2526.1: waits.
  bool awaits() const noexcept { return state_ == State::Waiting; }
  /// r2526.2: has the value that is asked for, until nothing is asked for.
  bool has_captured() const noexcept { return state_ == State::Captured; }
  /// A07495: the event did not come and is not waited for any more.
  bool is_interrupted() const noexcept { return state_ == State::Interrupted || withdrawn_; }
  /// A07498: why it cannot be waited for; 0: it can.
  std::int32_t refusal() const noexcept { return state_ == State::Refused ? refusal_ : 0; }

 private:
  enum class State : std::uint8_t { Idle, Waiting, Captured, Interrupted, Refused };

  void start(const CaptureRequest& request, const CaptureTerminals& terminals) noexcept;
  void wait_for(std::int32_t terminal, bool falling) noexcept;
  std::optional<Captured> look_for_mark(const DiscMotion& motion, const InputEdges& edges) const noexcept;
  std::optional<Captured> look_for_edge(const InputEdges& edges) const noexcept;

  State state_ = State::Idle;
  CaptureRequest before_{};
  std::int32_t terminal_ = 0;        // that is waited for, 0: a zero mark
  std::int32_t mark_selection_ = 0;  // of a zero mark
  bool falling_ = false;
  bool withdrawn_ = false;
  std::int32_t refusal_ = 0;
};

}  // namespace drive
