#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "cia402/inputs/input_event.hpp"

namespace cia402 {

/// A touch probe (CiA 402-2): it keeps position and time of edges.
class TouchProbe {
 public:
  /// What it keeps of an edge.
  struct Latch {
    std::int32_t position = 0;  ///< 60BAh..60BDh: 6064h at the edge (position units)
    std::uint32_t stamp = 0;    ///< 60D1h..60D4h (µs)
    std::uint16_t count = 0;    ///< 60D5h..60D8h: edges that it has kept since power-on, wraps
  };

  /// @p number is 1 or 2: its input, if the function asks for no other source.
  explicit constexpr TouchProbe(std::uint8_t number) noexcept : number_{number} {}

  /// Its six bits of 60B8h, the lowest first, and its source of 60D0h; edges before @p instant (0..1 of the cycle
  /// that runs) are none of its own.
  void set(std::uint8_t function, std::int16_t source, double instant) noexcept;
  /// Whether it keeps this event, as an edge that rises or else falls.
  bool wants(const InputEvent& event, bool rising) const noexcept;
  void keep(std::int32_t position, std::uint32_t stamp, bool rising) noexcept;
  /// The cycle in which set() came is over.
  void end_cycle() noexcept { armed_from_ = 0.0; }

  /// Its eight bits of 60B9h.
  std::uint8_t status() const noexcept { return status_; }
  const Latch& rising() const noexcept { return latches_[0]; }
  const Latch& falling() const noexcept { return latches_[1]; }

 private:
  std::optional<Signal> signal() const noexcept;

  std::uint8_t number_;
  std::uint8_t function_ = 0;
  std::int16_t source_ = 0;
  std::uint8_t status_ = 0;
  double armed_from_ = 0.0;
  std::array<Latch, 2> latches_{};  // rising, falling
};

/// Both touch probes of an axis.
class TouchProbes {
 public:
  /// 60B8h and 60D0h:1, :2 have the values @p function and @p sources from @p instant (0..1) of the running cycle
  /// on.
  void set(std::uint16_t function, const std::array<std::int16_t, 2>& sources, double instant = 0.0) noexcept;
  /// A cycle has passed that began at @p begin (µs) and had @p events. @p position_of tells what 6064h is at a
  /// position of the motor (increments).
  template <std::invocable<double> PositionOf>
  void pass(std::span<const InputEvent> events, std::uint64_t begin, const PositionOf& position_of) noexcept {
    for (TouchProbe& probe : probes_) {
      for (const InputEvent& event : events)
        for (const bool rising : {true, false})
          if (probe.wants(event, rising)) probe.keep(position_of(event.position), stamp_of(event, begin), rising);
      probe.end_cycle();
    }
  }

  /// 60B9h.
  std::uint16_t status() const noexcept {
    return static_cast<std::uint16_t>(probes_[0].status() | probes_[1].status() << 8);
  }
  /// Probe 1 or 2 by @p index 0 or 1.
  const TouchProbe& probe(std::size_t index) const noexcept { return probes_[index]; }

 private:
  static std::uint32_t stamp_of(const InputEvent& event, std::uint64_t begin) noexcept;

  std::array<TouchProbe, 2> probes_{TouchProbe{1}, TouchProbe{2}};
};

}  // namespace cia402
