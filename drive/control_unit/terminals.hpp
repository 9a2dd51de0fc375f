#pragma once

#include <cstdint>

#include "drive/base/input_edges.hpp"

namespace drive {

/// The terminals of the control unit: the digital ones, a bit each as r0722 numbers them, inputs DI 0 to 7, 16,
/// 17, 20 and 21, and DI/DO 8 to 15, which are inputs until p0728 makes outputs of them; and an analogue input.
class Terminals {
 public:
  using Word = std::uint32_t;
  static constexpr Word kBidirectional = 0x0000FF00;
  static constexpr Word kAll = 0x003300FF | kBidirectional;
  static constexpr unsigned kHighest = 21;
  /// DI/DO 8 is bit 8.
  static constexpr unsigned kFirstOutput = 8;
  static constexpr unsigned kOutputs = 8;

  /// Whether there is a terminal @p number.
  static constexpr bool exists(unsigned number) noexcept {
    return number <= kHighest && (kAll >> number & 1U) != 0;
  }
  /// Whether terminal @p number is an output (p0728).
  constexpr bool is_output(unsigned number) const noexcept {
    return number <= kHighest && (directions >> number & 1U) != 0;
  }

  /// Somebody outside puts terminal @p number, which exists, to 24 V or 0 V. From then on no switch feeds it.
  constexpr void apply(unsigned number, bool high) noexcept {
    const Word bit = Word{1} << number;
    forced_ |= bit;
    applied_ = high ? applied_ | bit : applied_ & ~bit;
  }
  /// A slice of time has passed in which the switches at the inputs @p fed, a bit each, did what @p switches
  /// tells.
  constexpr void pass_slice(const InputEdges& switches, Word fed) noexcept;
  /// DI 0 to 7 in the last slice: r0722 at its end and its edges. What is applied or simulated between two slices
  /// has its edge at the beginning of the second.
  constexpr const InputEdges& edges() const noexcept { return edges_; }

  /// What is connected outside puts @p voltage (V) to the analogue input.
  constexpr void apply_analog(double voltage) noexcept { analog_ = voltage; }
  /// r0752: that voltage (V).
  constexpr double analog() const noexcept { return analog_; }

  /// r0721: what comes in; 0 of an output.
  constexpr Word levels() const noexcept { return applied_ & inputs(); }
  /// r0722: the same, with what p0795 and p0796 simulate in its place.
  constexpr Word status() const noexcept {
    return ((applied_ & ~simulated) | (simulation & simulated)) & inputs();
  }
  /// r0723: r0722 inverted.
  constexpr Word inverted_status() const noexcept { return ~status() & kAll; }
  /// r0747: what the sources say, inverted by p0748, whether or not p0728 gives the terminal to it.
  constexpr Word outputs() const noexcept { return (sources ^ inversions) & kBidirectional; }

  Word directions = 0;  ///< p0728, 1 = output
  Word inversions = 0;  ///< p0748
  Word simulated = 0;   ///< p0795
  Word simulation = 0;  ///< p0796
  Word sources = 0;     ///< what p0738 to p0745 are connected to, of the last cycle

 private:
  constexpr Word inputs() const noexcept { return kAll & ~directions; }

  Word applied_ = 0;
  Word forced_ = 0;  // applied from outside
  double analog_ = 0.0;
  InputEdges edges_{};
};

constexpr void Terminals::pass_slice(const InputEdges& switches, Word fed) noexcept {
  const Word before = edges_.levels;
  fed &= ~forced_;
  applied_ = (applied_ & ~fed) | (switches.levels & fed);
  const Word told = fed & ~simulated;
  const Word now = status();
  edges_ = {.levels = static_cast<std::uint8_t>(now)};
  for (unsigned input = 0; input < InputEdges::kInputs; ++input) {
    const Word bit = Word{1} << input;
    if ((told & bit) != 0) {
      edges_.rising[input] = switches.rising[input];
      edges_.falling[input] = switches.falling[input];
    } else if (((before ^ now) & bit) != 0) {
      constexpr double kBeginning = 0.0;
      ((now & bit) != 0 ? edges_.rising : edges_.falling)[input] = kBeginning;
    }
  }
}

}  // namespace drive
