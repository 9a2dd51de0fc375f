#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace drive {

/// Bits of the controlword that no binector input takes, by their numbers in CiA 402.
enum class ControlwordBit : unsigned {
  EnableRamp = 4,     ///< in velocity mode
  UnlockRamp = 5,     ///< in velocity mode
  ReferenceRamp = 6,  ///< in velocity mode
  Halt = 8,
};

/// The interfaces of a drive object to process data.
enum class PzdInterface : std::uint8_t {
  If1,  ///< PROFIdrive
  If2,  ///< the CAN bus
};

/// The process data (PZD) of a drive object on one interface, in words of 16 bits: what a face brings and what it
/// fetches, and the words that converters make of bits. A double word is two words, the upper one first. A face,
/// that of a field bus or another, fills it before a cycle and shows it after that; the drive object sees it
/// through its interconnections only.
template <std::size_t Received, std::size_t Sent>
struct InterfaceImage {
  static constexpr std::size_t kReceivedWords = Received;
  static constexpr std::size_t kSentWords = Sent;

  std::array<std::uint16_t, kReceivedWords> received{};  ///< r8850, r8860, r8890 to r8893; of IF1 r2050, ...
  std::array<std::uint16_t, kSentWords> sent{};          ///< r8853, r8863; of IF1 r2053, r2063
  std::array<std::uint16_t, 5> words_of_bits{};          ///< r8889; of IF1 r2089
  std::array<std::uint16_t, 2> bits_of_words{};          ///< r8894, r8895; of IF1 r2094, r2095
  std::array<bool, 3> interface_state{};                 ///< r8843; of IF1 r2043

  /// The double word that begins at word @p place of @p words.
  template <std::size_t Count>
  static std::uint32_t double_word(const std::array<std::uint16_t, Count>& words, std::size_t place) noexcept {
    return std::uint32_t{words[place]} << 16 | words[place + 1];
  }
  template <std::size_t Count>
  static void set_double_word(std::array<std::uint16_t, Count>& words, std::size_t place,
                              std::uint32_t value) noexcept {
    words[place] = static_cast<std::uint16_t>(value >> 16);
    words[place + 1] = static_cast<std::uint16_t>(value);
  }
};

/// The process data on IF1, of which a kind of drive object has the first so many words.
struct If1Image : InterfaceImage<32, 32> {};

/// The process data on IF2, and what else the CAN bus brings.
struct ProcessDataImage : InterfaceImage<20, 25> {
  /// What a face brings that has no place in the words; 0 for what has one.
  struct Unplaced {
    std::uint16_t controlword = 0;               ///< r8795
    std::int16_t speed_rpm = 0;                  ///< r8792 (rpm)
    std::int32_t speed_increments = 0;           ///< r8796 (scales.increments_per_radian a rad/s)
    std::int16_t torque = 0;                     ///< r8797 (per mille of scales.rated_torque)
    std::array<std::int16_t, 16> words{};        ///< r8745
    std::array<std::int32_t, 8> double_words{};  ///< r8747
  };
  Unplaced unplaced{};

  /// The controlword, whether it has a place or not: for its bits that no binector input takes, halt (8) and in
  /// velocity mode those of the ramp (4 to 6).
  std::uint16_t controlword = 0;
  bool bit(ControlwordBit name) const noexcept { return (controlword >> static_cast<unsigned>(name) & 1U) != 0; }
  /// The mode of operation that a face asks for with every cycle; nothing: p1300 says it.
  std::optional<std::int8_t> requested_mode{};
  /// What r8796 and r8797 are relative to; changed by DriveObject::scale_process_data().
  struct Scales {
    double increments_per_radian = 1.0;  ///< increments/s for one rad/s
    double rated_torque = 1.0;           ///< 1000 per mille (N·m)

    friend bool operator==(const Scales&, const Scales&) = default;
  };
  Scales scales{};
};

/// What converters between words and bits of interface @p Interface invert.
template <PzdInterface Interface>
struct ConverterSettings {
  std::array<std::uint16_t, 5> invert_words_of_bits{};  ///< p8888, of r8889; p2088, of r2089
  std::array<std::uint16_t, 2> invert_bits_of_words{};  ///< p8898, of r8894 and r8895; p2098, of r2094 and r2095
};
using If1Converters = ConverterSettings<PzdInterface::If1>;
using Converters = ConverterSettings<PzdInterface::If2>;

}  // namespace drive
