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
  word_sources_.reserve(bits_of_words_.size());
  sent_words_.reserve(sent_.size());
  sent_double_words_.reserve(sent_.size());
}

void ImageLinks::clear() noexcept {
  for (auto* const places : {&bit_sources_, &word_sources_, &sent_words_, &sent_double_words_}) places->clear();
  std::ranges::fill(sent_, std::uint16_t{0});
  std::ranges::copy(inverted_words_, constant_words_.begin());
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

void ImageLinks::connect_bit(const Place& place) noexcept {
  if (!place.source.is_constant()) return bit_sources_.push_back(place);
  std::uint16_t& word = constant_words_[place.word];
  word = static_cast<std::uint16_t>(word ^ static_cast<unsigned>(place.source.bit()) << place.bit);
  words_of_bits_[place.word] = word;
}

void ImageLinks::convert_words() noexcept {
  for (const Place& place : word_sources_)
    bits_of_words_[place.word] = static_cast<std::uint16_t>(word_of(place.source) ^ inverted_bits_[place.word]);
}

void ImageLinks::convert_bits() noexcept {
  auto words = constant_words_;
  for (const Place& place : bit_sources_)
    words[place.word] =
        static_cast<std::uint16_t>(words[place.word] ^ (static_cast<unsigned>(place.source.bit()) << place.bit));
  std::ranges::copy(words, words_of_bits_.begin());
}

void ImageLinks::send() noexcept {
  for (const Place& place : sent_words_) sent_[place.word] = word_of(place.source);
  for (const Place& place : sent_double_words_) {
    const auto value = static_cast<std::uint32_t>(place.source.process_data<std::int32_t>());
    sent_[place.word] = static_cast<std::uint16_t>(value >> 16);
    sent_[place.word + 1] = static_cast<std::uint16_t>(value);
  }
}

}  // namespace drive
