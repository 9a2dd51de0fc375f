#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace drive {

/// The encoder interface of PROFIdrive, of the motor encoder: control word Gn_STW to status word Gn_ZSW. Absolute
/// value, parking, reading and acknowledging are carried out; a search for marks or a measurement is answered as
/// active until it is cancelled, since none ever finds anything. Gn_XIST1 counts on whatever is asked for.
class EncoderInterface {
 public:
  static constexpr std::size_t kEncoders = 3;

  struct Settings {};
  struct Inputs {
    using Block = EncoderInterface;

    std::array<double, kEncoders> control_words{};  ///< p0480

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  /// What the encoder is at.
  struct Seen {
    std::uint32_t position = 0;  ///< Gn_XIST1
    bool faulty = false;         ///< one of its faults is active
    bool cause_present = false;  ///< and cannot be acknowledged yet
  };

  /// Whether run() has something to do.
  bool is_asked() const noexcept { return inputs.control_words[0] != taken_; }
  /// Answers the control word.
  void run(const Seen& seen) noexcept;

  /// Gn_ZSW of the encoder, which has a fault if @p faulty.
  std::uint16_t status(bool faulty) const noexcept;
  /// Gn_XIST2: what the control word asks for, an error code where status() has its bit 15, or the absolute
  /// position @p absolute of the encoder, which is also there while nothing is asked for.
  std::uint32_t second_value(bool faulty, std::uint32_t absolute) const noexcept;

  Settings settings{};
  Inputs inputs{};

 private:
  bool has(unsigned bit) const noexcept { return (control_ >> bit & 1U) != 0; }
  bool shows_fault(bool faulty) const noexcept;
  void command(unsigned command, unsigned functions, std::uint32_t position) noexcept;

  double taken_ = 0.0;         // the word as it was last taken, no number while a fault is watched
  std::uint16_t control_ = 0;  // the same as bits
  unsigned active_ = 0;        // functions 1 to 4, a bit each
  unsigned available_ = 0;     // those whose value was read
  std::uint32_t read_ = 0;     // it
  bool acknowledged_ = false;  // the fault that is active
};

}  // namespace drive
