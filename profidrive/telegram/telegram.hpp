#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "drive/base/function_modules.hpp"
#include "drive/base/object_kind.hpp"

namespace profidrive {

/// Whether an input belongs to a word on axes with or without the extended setpoint channel only.
enum class SetpointChannel : std::uint8_t { Either, With, Without };

/// An input that a received word leads to.
struct Sink {
  /// What of the word it takes.
  enum class Part : std::uint8_t {
    Bit,            ///< a bit, r2090 to r2093; of the word itself
    Word,           ///< all of it, r2050
    DoubleWord,     ///< with the word behind it, r2060
    FirstConverter  ///< a bit of r2094, which the word or another source leads to
  };

  std::uint16_t input;
  Part part;
  std::uint16_t bit = 0;
  std::uint8_t index = 0;
  SetpointChannel channel = SetpointChannel::Either;
};

/// A word or double word that is received.
struct ReceivedWord {
  std::string_view name;
  std::uint8_t words = 1;
  std::array<std::span<const Sink>, 3> sinks{};
  bool is_free = false;           ///< nothing is wired there and nothing locked
  bool has_sign_of_life = false;  ///< in bits 12 to 15
};

/// The source of a bit of a status word; number 0: constantly 0.
struct StatusBit {
  std::uint16_t number = 0;
  std::uint8_t bit = 0;
  bool inverted = false;
};
using StatusBits = std::array<StatusBit, 16>;

/// A word or double word that is sent.
struct SentWord {
  std::string_view name;
  std::uint8_t words = 1;
  /// The connector that it shows; 0: nothing.
  std::uint16_t source = 0;
  std::uint8_t index = 0;
  /// The bits that it is made of, in converter @p converter (p2080 to p2084, r2089), instead.
  const StatusBits* bits = nullptr;
  std::uint8_t converter = 0;
  bool is_free = false;             ///< what is wired there is a proposal and not locked
  bool has_sign_of_life = false;    ///< in bits 12 to 15
  bool shows_synchronised = false;  ///< in bit 8 whether the clock of the unit is synchronised
  std::uint16_t converted = 0;      ///< the connector that its bits of r2094 come from (p2099[0])
};

/// A telegram: what p0922 and p2079 select.
struct Telegram {
  std::uint16_t number;
  drive::ObjectKinds kinds;
  bool positions;               ///< of axes with the basic positioner, otherwise of those without
  std::uint8_t interface_mode;  ///< p2038
  std::span<const ReceivedWord* const> received;
  std::span<const SentWord* const> sent;
  bool has_parameter_channel = false;  ///< four words of PKW before the others, which count from behind them
  bool on_any_axis = false;            ///< whether it positions or not
};

/// Words of @p list, a double word being two.
template <class Word>
constexpr std::size_t words_of(std::span<const Word* const> list) noexcept {
  std::size_t words = 0;
  for (const Word* const word : list) words += word->words;
  return words;
}

}  // namespace profidrive
