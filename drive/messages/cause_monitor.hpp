#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "drive/base/elapsed.hpp"
#include "drive/messages/cause.hpp"

namespace drive {

/// What follows from the causes of a message.
struct Verdict {
  std::uint16_t message;
  bool present;
  std::uint32_t value;
};

/// Judges the causes that the blocks of one axis have, with their delays and hystereses. Blocks is a std::tuple.
template <class Blocks>
class CauseMonitor;

template <class... Block>
class CauseMonitor<std::tuple<Block...>> {
 public:
  using Blocks = std::tuple<Block...>;
  static constexpr std::size_t kCount = (std::tuple_size_v<std::decay_t<decltype(causes_of<Block>)>> + ...);

  /// Calls @p tell with the verdict on each message that has a cause, and once when it has none any more,
  /// ascending by message, @p duration (s) after the last call.
  template <class Tell>
  void update(double duration, const Blocks& blocks, bool pulses_enabled, const Tell& tell) noexcept {
    judge_all(duration, blocks, pulses_enabled, std::make_index_sequence<kCount>{});
    if ((present_ | told_) != 0) [[unlikely]]
      tell_all(blocks, tell);
  }

  /// Whether a cause held at the last call.
  bool any_present() const noexcept { return present_ != 0; }
  /// Whether one of @p message did.
  bool holds(std::uint16_t message) const noexcept {
    for (std::size_t i = 0; i < kCount; ++i)
      if (kPlaces[i].message == message && (present_ >> i & 1U) != 0) return true;
    return false;
  }
  /// The message of cause @p index.
  static constexpr std::uint16_t message(std::size_t index) noexcept { return kPlaces[index].message; }

 private:
  using Mask = std::uint64_t;
  static_assert(kCount <= 64, "a bit a cause");

  /// Where the row of a cause is.
  struct Place {
    std::uint16_t message = 0;
    std::size_t block = 0;
    std::size_t row = 0;
  };
  static constexpr std::array<Place, kCount> kPlaces = [] {
    std::array<Place, kCount> places{};
    std::size_t count = 0;
    std::size_t block = 0;
    const auto append = [&](const auto& rows) {
      for (std::size_t row = 0; row < rows.size(); ++row)
        if constexpr (requires { rows[row].message; }) places[count++] = {rows[row].message, block, row};
      ++block;
    };
    (append(causes_of<Block>), ...);
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return a.message != b.message ? a.message < b.message : a.row < b.row;
    });
    return places;
  }();
  static constexpr bool is_last(std::size_t index) noexcept {
    return index + 1 == kCount || kPlaces[index + 1].message != kPlaces[index].message;
  }
  template <std::size_t Index>
  using BlockOf = std::tuple_element_t<kPlaces[Index].block, Blocks>;
  template <std::size_t Index>
  static constexpr const auto& row() noexcept {
    return causes_of<BlockOf<Index>>[kPlaces[Index].row];
  }

  template <std::size_t... Index>
  void judge_all(double duration, const Blocks& blocks, bool pulses, std::index_sequence<Index...>) noexcept {
    Mask present = 0;
    ((present |= static_cast<Mask>(judge<Index>(duration, std::get<BlockOf<Index>>(blocks), pulses)) << Index),
     ...);
    present_ = present;
  }

  template <std::size_t Index>
  [[gnu::always_inline]] bool judge(double duration, const BlockOf<Index>& block, bool pulses) noexcept {
    constexpr const auto& cause = row<Index>();
    if constexpr (cause.pulses != Pulses::Any)
      if (pulses != (cause.pulses == Pulses::On)) return forget<Index>();
    const double beyond = (block.*cause.quantity)() - cause.threshold.of(block);
    const double distance = cause.side == Side::Above ? beyond : -beyond;
    const bool was = (present_ >> Index & 1U) != 0;
    if (!(distance > (was ? -cause.hysteresis : 0.0))) return forget<Index>();
    if constexpr (cause.delay.is_zero()) return true;
    times_[Index] += duration;
    return was || elapsed(times_[Index], cause.delay.of(block));
  }
  template <std::size_t Index>
  bool forget() noexcept {
    if constexpr (!row<Index>().delay.is_zero()) times_[Index] = 0.0;
    return false;
  }

  template <class Tell>
  void tell_all(const Blocks& blocks, const Tell& tell) noexcept {
    Verdict verdict{};
    for (std::size_t i = 0; i < kCount; ++i) {
      const Mask bit = Mask{1} << i;
      if (kPlaces[i].message != verdict.message) verdict = {kPlaces[i].message, false, 0};
      if ((present_ & bit) != 0) verdict = {kPlaces[i].message, true, kValues[i](blocks)};
      if (!is_last(i)) continue;
      if (verdict.present || (told_ & bit) != 0) tell(verdict);
      told_ = verdict.present ? told_ | bit : told_ & ~bit;
    }
  }

  template <std::size_t Index>
  static std::uint32_t value_of(const Blocks& blocks) noexcept {
    constexpr const auto& cause = row<Index>();
    constexpr double kHighest = 4294967295.0;
    if constexpr (!cause.value.is_shown)
      return 0;
    else {
      const double value = (std::get<BlockOf<Index>>(blocks).*cause.value.getter)();
      return static_cast<std::uint32_t>(std::clamp(std::round(value * cause.value_scale), 0.0, kHighest));
    }
  }
  template <std::size_t... Index>
  static constexpr auto values(std::index_sequence<Index...>) noexcept {
    return std::array{&value_of<Index>...};
  }
  static constexpr std::array<std::uint32_t (*)(const Blocks&) noexcept, kCount> kValues =
      values(std::make_index_sequence<kCount>{});

  std::array<double, kCount> times_{};  // s, so long beyond the threshold, of causes with a delay
  Mask present_ = 0;                    // a bit a cause
  Mask told_ = 0;                       // of the last row of a message: it was present at the last call
};

}  // namespace drive
