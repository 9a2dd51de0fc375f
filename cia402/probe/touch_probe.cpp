#include "cia402/probe/touch_probe.hpp"

#include <cmath>

namespace cia402 {
namespace {

// Bits of 60B8h, for probe 1.
constexpr unsigned kEnable = 1U << 0U;
constexpr unsigned kContinuous = 1U << 1U;
constexpr unsigned kSource = 3U << 2U;
constexpr unsigned kOwnInput = 0U << 2U;
constexpr unsigned kIndex = 1U << 2U;
constexpr unsigned kBySourceObject = 2U << 2U;
constexpr unsigned kRising = 1U << 4U;
constexpr unsigned kFalling = 1U << 5U;
/// What arms a probe anew when it changes.
constexpr unsigned kArms = kEnable | kSource | kRising | kFalling;

// Bits of 60B9h, for probe 1.
constexpr unsigned kEnabled = 1U << 0U;
constexpr unsigned kRisingKept = 1U << 1U;
constexpr unsigned kFallingKept = 1U << 2U;
constexpr unsigned kRisingToggles = 1U << 6U;
constexpr unsigned kFallingToggles = 1U << 7U;
constexpr unsigned kToggles = kRisingToggles | kFallingToggles;

// Values of 60D0h.
constexpr std::int16_t kSourceIndex = 5;
constexpr std::int16_t kSourceZero = 6;

/// The input of a touch probe; there are two.
constexpr std::optional<Signal> input(int number) noexcept {
  if (number == 1) return Signal::Probe1;
  if (number == 2) return Signal::Probe2;
  return std::nullopt;
}

constexpr double kMicrosecondsInACycle = 1000.0;

}  // namespace

void TouchProbe::set(std::uint8_t function, std::int16_t source, double instant) noexcept {
  const bool changes_source = (function & kSource) == kBySourceObject && source != source_;
  const bool arms = ((function ^ function_) & kArms) != 0 || changes_source;
  function_ = function;
  source_ = source;
  if ((function & kEnable) == 0) {
    status_ = 0;
  } else if (arms) {
    status_ = static_cast<std::uint8_t>((status_ & kToggles) | kEnabled);
    armed_from_ = instant;
  }
}

/// Where its edges come from; no probe has the inputs 3 and 4.
std::optional<Signal> TouchProbe::signal() const noexcept {
  const unsigned source = function_ & kSource;
  if (source == kOwnInput) return input(number_);
  if (source == kIndex) return Signal::Index;
  if (source != kBySourceObject) return std::nullopt;
  if (source_ == kSourceIndex) return Signal::Index;
  if (source_ == kSourceZero) return Signal::SoftwareZero;
  return input(source_);
}

bool TouchProbe::wants(const InputEvent& event, bool rising) const noexcept {
  if ((function_ & kEnable) == 0 || (function_ & (rising ? kRising : kFalling)) == 0) return false;
  const Edge edge = rising ? Edge::Rising : Edge::Falling;
  if (signal() != event.signal || (event.edge != edge && event.edge != Edge::Pulse)) return false;
  const bool has_one = (status_ & (rising ? kRisingKept : kFallingKept)) != 0;
  return event.instant >= armed_from_ && (!has_one || (function_ & kContinuous) != 0);
}

void TouchProbe::keep(std::int32_t position, std::uint32_t stamp, bool rising) noexcept {
  Latch& latch = latches_[rising ? 0 : 1];
  latch.position = position;
  latch.stamp = stamp;
  ++latch.count;
  unsigned status = status_ | (rising ? kRisingKept : kFallingKept);
  if ((function_ & kContinuous) != 0) status ^= rising ? kRisingToggles : kFallingToggles;
  status_ = static_cast<std::uint8_t>(status);
}

void TouchProbes::set(std::uint16_t function, const std::array<std::int16_t, 2>& sources,
                      double instant) noexcept {
  probes_[0].set(static_cast<std::uint8_t>(function & 0x3FU), sources[0], instant);
  probes_[1].set(static_cast<std::uint8_t>((function >> 8U) & 0x3FU), sources[1], instant);
}

std::uint32_t TouchProbes::stamp_of(const InputEvent& event, std::uint64_t begin) noexcept {
  return static_cast<std::uint32_t>(
      begin + static_cast<std::uint64_t>(std::llround(event.instant * kMicrosecondsInACycle)));
}

}  // namespace cia402
