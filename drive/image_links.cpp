#include "drive/image_links.hpp"

#include <algorithm>

namespace drive {
namespace {

std::uint16_t word_of(const SignalSource& source) noexcept {
  return static_cast<std::uint16_t>(source.process_data<std::int16_t>());
}

}  // namespace

void ImageLinks::reserve(std::size_t bits) {
  bit_sources_.reserve(bits);
  words_of_sources_.reserve(bits);
  word_sources_.reserve(bits_of_words_.size());
  sent_words_.reserve(sent_.size());
  sent_double_words_.reserve(sent_.size());
}

void ImageLinks::clear() noexcept {
  for (auto* const places : {&bit_sources_, &word_sources_, &sent_words_, &sent_double_words_}) places->clear();
  std::ranges::fill(sent_, std::uint16_t{0});
  words_of_sources_.clear();
  std::ranges::copy(inverted_words_, words_of_bits_.begin());
  std::ranges::copy(inverted_bits_, bits_of_words_.begin());
}

void ImageLinks::connect(const ImageInput& input, std::size_t index, const SignalSource& from) noexcept {
  const bool is_wired = !from.is_constant() || from.bit();
  switch (input.sink) {
    case ImageSink::SentWord:
      if (is_wired) sent_words_.push_back({index, 0, from});
      break;
    case ImageSink::SentDoubleWord:
      if (is_wired) sent_double_words_.push_back({index, 0, from});
      break;
    case ImageSink::WordOfBits:
      connect_word({index, 0, from});
      break;
    case ImageSink::BitOfWord:
      connect_bit({input.place, index, from});
      break;
  }
}

void ImageLinks::connect_word(const Place& place) noexcept {
  if (!place.source.is_constant()) return word_sources_.push_back(place);
  bits_of_words_[place.word] = static_cast<std::uint16_t>(word_of(place.source) ^ inverted_bits_[place.word]);
}

/// Bits of the same word stand side by side.
void ImageLinks::connect_bit(const Place& place) noexcept {
  if (place.source.is_constant()) return set_bit(place, place.source.bit());
  const auto last = std::find_if(bit_sources_.rbegin(), bit_sources_.rend(),
                                 [&](const Place& other) { return other.source.shares_word(place.source); });
  bit_sources_.insert(last != bit_sources_.rend() ? last.base() : bit_sources_.end(), place);
}

void ImageLinks::set_bit(const Place& place, bool level) noexcept {
  const unsigned mask = 1U << place.bit;
  const bool is_set = level != ((inverted_words_[place.word] & mask) != 0);
  std::uint16_t& word = words_of_bits_[place.word];
  word = static_cast<std::uint16_t>(is_set ? word | mask : word & ~mask);
}

void ImageLinks::finish() noexcept {
  for (std::size_t i = 0; i < bit_sources_.size(); ++i) {
    const SignalSource& source = bit_sources_[i].source;
    if (i == 0 || !source.shares_word(bit_sources_[i - 1].source)) words_of_sources_.push_back({source, i});
    ++words_of_sources_.back().count;
  }
}

void ImageLinks::convert_words() noexcept {
  for (const Place& place : word_sources_)
    bits_of_words_[place.word] = static_cast<std::uint16_t>(word_of(place.source) ^ inverted_bits_[place.word]);
}

void ImageLinks::convert_bits() noexcept {
  for (Word& word : words_of_sources_) {
    const double now = word.source.word();
    if (now == word.taken) continue;
    word.taken = now;
    for (const Place& place : std::span{bit_sources_}.subspan(word.first, word.count))
      set_bit(place, place.source.bit(now));
  }
}

/// A word changes with the number of its source alone.
void ImageLinks::send() noexcept {
  for (Place& place : sent_words_) {
    const double now = place.source.number();
    if (now == place.taken) continue;
    place.taken = now;
    sent_[place.word] = static_cast<std::uint16_t>(place.source.process_data<std::int16_t>(now));
  }
  for (Place& place : sent_double_words_) {
    const double now = place.source.number();
    if (now == place.taken) continue;
    place.taken = now;
    const auto value = static_cast<std::uint32_t>(place.source.process_data<std::int32_t>(now));
    sent_[place.word] = static_cast<std::uint16_t>(value >> 16);
    sent_[place.word + 1] = static_cast<std::uint16_t>(value);
  }
}

}  // namespace drive
