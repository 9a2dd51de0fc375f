#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "drive/signal_source.hpp"

namespace drive {

/// What of the process data of a drive object on one interface its interconnections bring: words that are sent,
/// words made of bits, words shown as bits. What is constant is settled once, what is not is a list of sources.
class ImageLinks {
 public:
  /// Of @p image, whose converters invert by @p settings; both outlive this.
  template <class Image, class Settings>
  ImageLinks(Image& image, const Settings& settings) noexcept
      : sent_{image.sent},
        words_of_bits_{image.words_of_bits},
        bits_of_words_{image.bits_of_words},
        inverted_words_{settings.invert_words_of_bits},
        inverted_bits_{settings.invert_bits_of_words} {}

  /// Makes room for @p bits binector inputs, so that nothing is allocated later.
  void reserve(std::size_t bits);
  /// Everything is to be connected anew: nothing is sent, and words of bits are what inverts them.
  void clear() noexcept;
  /// Index @p index of @p input is connected to @p from.
  void connect(const ImageInput& input, std::size_t index, const SignalSource& from) noexcept;
  /// Everything is connected.
  void finish() noexcept;

  bool has_words() const noexcept { return !word_sources_.empty(); }
  bool has_bits() const noexcept { return !bit_sources_.empty(); }
  bool sends() const noexcept { return !sent_words_.empty() || !sent_double_words_.empty(); }
  /// What converters from words to bits make of the words as they are.
  void convert_words() noexcept;
  /// What converters from bits to words make of the bits as they are.
  void convert_bits() noexcept;
  /// Puts what is to be sent into its places.
  void send() noexcept;

 private:
  /// A bit or a word of process data.
  struct Place {
    std::size_t word = 0;
    std::size_t bit = 0;
    SignalSource source{};
    double taken = std::numeric_limits<double>::quiet_NaN();  ///< the number that was last sent
  };
  /// A word that brings bits, which stand side by side.
  struct Word {
    SignalSource source;
    std::size_t first = 0;
    std::size_t count = 0;
    double taken = std::numeric_limits<double>::quiet_NaN();  ///< what it was when its bits were last taken
  };
  void connect_bit(const Place& place) noexcept;
  void set_bit(const Place& place, bool level) noexcept;
  void connect_word(const Place& place) noexcept;

  std::span<std::uint16_t> sent_;
  std::span<std::uint16_t, 5> words_of_bits_;
  std::span<std::uint16_t, 2> bits_of_words_;
  std::span<const std::uint16_t, 5> inverted_words_;
  std::span<const std::uint16_t, 2> inverted_bits_;
  std::vector<Place> bit_sources_;
  std::vector<Word> words_of_sources_;  ///< of the bits
  std::vector<Place> word_sources_;
  std::vector<Place> sent_words_;
  std::vector<Place> sent_double_words_;
};

}  // namespace drive
