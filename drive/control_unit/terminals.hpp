#pragma once

#include <cstdint>

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

  /// What is connected outside puts terminal @p number, which exists, to 24 V or 0 V.
  constexpr void apply(unsigned number, bool high) noexcept {
    const Word bit = Word{1} << number;
    applied_ = high ? applied_ | bit : applied_ & ~bit;
  }

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
  double analog_ = 0.0;
};

}  // namespace drive
