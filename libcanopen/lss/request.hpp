#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/little_endian.hpp"

/// What travels between an LSS master and a slave (CiA 305).
namespace canopen::lss {

inline constexpr Identifier kRequests = 0x7E5;  ///< of the master
inline constexpr Identifier kAnswers = 0x7E4;   ///< of all slaves
inline constexpr std::uint8_t kBytes = 8;       ///< of every frame

/// Command specifiers, the first byte of a frame.
namespace command {
inline constexpr std::uint8_t kSwitchGlobal = 0x04;
inline constexpr std::uint8_t kConfigureNodeId = 0x11;
inline constexpr std::uint8_t kConfigureBitTiming = 0x13;
inline constexpr std::uint8_t kActivateBitTiming = 0x15;
inline constexpr std::uint8_t kStore = 0x17;
inline constexpr std::uint8_t kSelectFirst = 0x40;    ///< vendor-ID; then product code, revision and serial number
inline constexpr std::uint8_t kSelected = 0x44;       ///< answer
inline constexpr std::uint8_t kIdentifyFirst = 0x46;  ///< vendor-ID; then product code and two ranges
inline constexpr std::uint8_t kIdentifyUnconfigured = 0x4C;
inline constexpr std::uint8_t kIdentified = 0x4F;      ///< answer
inline constexpr std::uint8_t kIsUnconfigured = 0x50;  ///< answer
inline constexpr std::uint8_t kFastscan = 0x51;
inline constexpr std::uint8_t kInquireFirst = 0x5A;  ///< vendor-ID; then the other three
inline constexpr std::uint8_t kInquireNodeId = 0x5E;
}  // namespace command

/// Error codes of "configure node-ID" and "configure bit timing".
inline constexpr std::uint8_t kDone = 0;
inline constexpr std::uint8_t kRefused = 1;  ///< out of range, not supported

/// Numbers of an identity (1018h).
inline constexpr std::uint8_t kNumbers = 4;

/// How a request of a sequence compares the number that it carries with that of the node.
enum class Comparison : std::uint8_t { Equal, AtLeast, AtMost };

/// One request of the sequences "switch state selective" and "identify remote slave".
struct Part {
  std::uint8_t command;
  std::uint8_t sub_index;  ///< of 1018h
  Comparison comparison;   ///< what the number of the node has to be
  std::uint8_t answer;     ///< that ends the sequence, 0: another request follows
};
inline constexpr std::array kParts{
    Part{0x40, 1, Comparison::Equal, 0},   Part{0x41, 2, Comparison::Equal, 0},
    Part{0x42, 3, Comparison::Equal, 0},   Part{0x43, 4, Comparison::Equal, command::kSelected},
    Part{0x46, 1, Comparison::Equal, 0},   Part{0x47, 2, Comparison::Equal, 0},
    Part{0x48, 3, Comparison::AtLeast, 0}, Part{0x49, 3, Comparison::AtMost, 0},
    Part{0x4A, 4, Comparison::AtLeast, 0}, Part{0x4B, 4, Comparison::AtMost, command::kIdentified},
};

/// The row of @p command; nullptr if it belongs to no sequence.
constexpr const Part* part_of(std::uint8_t command) noexcept {
  const auto* const row = std::ranges::find(kParts, command, &Part::command);
  return row != kParts.end() ? row : nullptr;
}

/// Does @p number, of a node, fit what @p part says with @p wanted?
constexpr bool fits(const Part& part, std::uint32_t number, std::uint32_t wanted) noexcept {
  switch (part.comparison) {
    case Comparison::Equal:
      return number == wanted;
    case Comparison::AtLeast:
      return number >= wanted;
    case Comparison::AtMost:
      return number <= wanted;
  }
  return false;
}

/// The bit rate in kbit/s of @p index in the table of CiA 305; none for what is reserved, and for automatic
/// detection.
constexpr std::optional<std::uint16_t> bit_rate_of(std::uint8_t index) noexcept {
  constexpr std::array<std::uint16_t, 9> kRates{1000, 800, 500, 250, 125, 0, 50, 20, 10};
  if (index >= kRates.size() || kRates[index] == 0) return std::nullopt;
  return kRates[index];
}

/// A request of fastscan.
struct Fastscan {
  static constexpr std::uint8_t kRestart = 0x80;  ///< in `lowest_bit`: who is there? Begin with the first number

  explicit Fastscan(const Frame& frame) noexcept
      : number{load<std::uint32_t>(&frame.data[1])},
        lowest_bit{frame.data[5]},
        position{frame.data[6]},
        next{frame.data[7]} {}

  /// True if the request is none that CiA 305 knows.
  bool is_void() const noexcept { return lowest_bit > 31 || position >= kNumbers || next >= kNumbers; }
  /// Has @p own, of a node, the bits that are asked for?
  bool fits(std::uint32_t own) const noexcept { return (own ^ number) >> lowest_bit == 0; }

  std::uint32_t number;
  std::uint8_t lowest_bit;  ///< that counts ("BitCheck"): those above count too
  std::uint8_t position;    ///< of the number in the identity ("LSS Sub"), from 0
  std::uint8_t next;        ///< the position that comes when all bits fit ("LSS Next")
};

}  // namespace canopen::lss
