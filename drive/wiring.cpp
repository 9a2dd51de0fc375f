#include "drive/wiring.hpp"

#include <algorithm>
#include <variant>

namespace drive {
namespace {

constexpr std::size_t kBitsOfAWord = 16;

/// Calls @p visit with every row of @p object that is an input, and with its home.
template <class Visit>
void for_each_input(const DriveObject& object, const Visit& visit) {
  for (const PlacedRow& placed : parameters_of(object.kind())) {
    const ParameterRow& row = *placed.row;
    if (const auto* const bit = std::get_if<BitInput>(&row.home)) visit(row, *bit);
    if (const auto* const value = std::get_if<ValueInput>(&row.home)) visit(row, *value);
    if (const auto* const word = std::get_if<ImageInput>(&row.home)) visit(row, *word);
  }
}

template <class Links>
void take_all(const Links& links) noexcept {
  for (const auto& link : links) *link.input = link.value();
}

template <class Links>
bool any_changed(const Links& links) noexcept {
  return std::ranges::any_of(links, [](const auto& link) { return link.value() != *link.input; });
}

}  // namespace

template <>
bool Wiring::Link<bool>::value() const noexcept {
  return source.bit();
}
template <>
double Wiring::Link<double>::value() const noexcept {
  return source.value(full);
}

Wiring::Wiring(DriveUnit& unit) : unit_{unit} {
  unit.for_each_object([this](DriveObject& object) { objects_.push_back({.object = &object}); });
  for (Object& entry : objects_) reserve(entry);
}

/// Makes room for all inputs, so that nothing is allocated later.
void Wiring::reserve(Object& entry) {
  std::size_t bits_of_words = 0;
  for_each_input(*entry.object, [&](const ParameterRow& row, const auto& input) {
    if constexpr (std::is_same_v<std::decay_t<decltype(input)>, ImageInput>)
      bits_of_words += input.sink == ImageSink::BitOfWord ? row.count : 0U;
    else
      inputs_of(entry, input.block).count += row.count;
  });
  for (Inputs& inputs : entry.blocks) {
    for (auto* const bits : {&inputs.bits, &inputs.constant_bits}) bits->reserve(inputs.count);
    for (auto* const values : {&inputs.values, &inputs.constant_values}) values->reserve(inputs.count);
  }
  entry.words_of_bits.reserve(bits_of_words);
  entry.bits_of_words.reserve(std::tuple_size_v<decltype(ProcessDataImage::bits_of_words)>);
  entry.sent_words.reserve(ProcessDataImage::kSentWords);
  entry.sent_double_words.reserve(ProcessDataImage::kSentWords);
}

Wiring::Inputs& Wiring::inputs_of(Object& entry, BlockId block) {
  const auto found = std::ranges::find(entry.blocks, block, &Inputs::block);
  return found != entry.blocks.end() ? *found : entry.blocks.emplace_back(Inputs{.block = block});
}

void Wiring::connect() noexcept {
  if (valid_) return;
  valid_ = true;
  for (Object& entry : objects_) connect(entry);
}

void Wiring::connect(Object& entry) noexcept {
  for (Inputs& inputs : entry.blocks) {
    for (auto* const bits : {&inputs.bits, &inputs.constant_bits}) bits->clear();
    for (auto* const values : {&inputs.values, &inputs.constant_values}) values->clear();
    inputs.constants_taken = false;
  }
  for (auto* const places :
       {&entry.words_of_bits, &entry.bits_of_words, &entry.sent_words, &entry.sent_double_words})
    places->clear();
  entry.constant_words_of_bits = {};
  entry.object->process_data().sent = {};
  for_each_input(*entry.object, [&](const ParameterRow& row, const auto& input) { connect(entry, row, input); });
}

SignalSource Wiring::source(const DriveObject& object, const ParameterRow& row, std::size_t index) const noexcept {
  return {unit_, object, static_cast<std::uint32_t>(object.read(row.number, index).value_or(0.0))};
}

void Wiring::connect(Object& entry, const ParameterRow& row, const BitInput& input) noexcept {
  Inputs& inputs = inputs_of(entry, input.block);
  void* const block = entry.object->block(input.block);
  for (std::size_t i = 0; i < row.count; ++i) {
    const SignalSource from = source(*entry.object, row, i);
    (from.is_constant() ? inputs.constant_bits : inputs.bits).push_back({&input.member(block, i), from});
  }
}

void Wiring::connect(Object& entry, const ParameterRow& row, const ValueInput& input) noexcept {
  Inputs& inputs = inputs_of(entry, input.block);
  void* const block = entry.object->block(input.block);
  const double full = reference(*entry.object, input.quantity);
  for (std::size_t i = 0; i < row.count; ++i) {
    const SignalSource from = source(*entry.object, row, i);
    (from.is_constant() ? inputs.constant_values : inputs.values).push_back({&input.member(block, i), from, full});
  }
}

void Wiring::connect(Object& entry, const ParameterRow& row, const ImageInput& input) noexcept {
  for (std::size_t i = 0; i < row.count; ++i) {
    const SignalSource from = source(*entry.object, row, i);
    const bool is_wired = !from.is_constant() || from.bit();
    switch (input.sink) {
      case ImageSink::SentWord:
        if (is_wired) entry.sent_words.push_back({i, 0, from});
        break;
      case ImageSink::SentDoubleWord:
        if (is_wired) entry.sent_double_words.push_back({i, 0, from});
        break;
      case ImageSink::WordOfBits:
        entry.bits_of_words.push_back({i, 0, from});
        break;
      case ImageSink::BitOfWord:
        connect_bit(entry, {input.place, i, from});
        break;
    }
  }
}

void Wiring::connect_bit(Object& entry, const Place& place) noexcept {
  if (!place.source.is_constant()) return entry.words_of_bits.push_back(place);
  std::uint16_t& word = entry.constant_words_of_bits[place.word];
  word = static_cast<std::uint16_t>(word ^ static_cast<unsigned>(place.source.bit()) << place.bit);
}

void Wiring::take(const DriveObject& object, BlockId block) noexcept {
  for (Inputs& inputs : objects_[object.number() - std::size_t{1}].blocks) {
    if (inputs.block != block) continue;
    if (!inputs.constants_taken) {
      take_all(inputs.constant_bits);
      take_all(inputs.constant_values);
      inputs.constants_taken = true;
    }
    take_all(inputs.bits);
    take_all(inputs.values);
  }
}

bool Wiring::changed(const DriveObject& object) const noexcept {
  return std::ranges::any_of(objects_[object.number() - std::size_t{1}].blocks, [](const Inputs& inputs) {
    return any_changed(inputs.bits) || any_changed(inputs.values) ||
           (!inputs.constants_taken && (any_changed(inputs.constant_bits) || any_changed(inputs.constant_values)));
  });
}

void Wiring::convert_words() noexcept {
  for (Object& entry : objects_) {
    const auto& inverted = entry.object->converters().invert_bits_of_words;
    for (const Place& place : entry.bits_of_words) {
      const auto word = static_cast<std::uint16_t>(place.source.process_data<std::int16_t>());
      entry.object->process_data().bits_of_words[place.word] =
          static_cast<std::uint16_t>(word ^ inverted[place.word]);
    }
  }
}

void Wiring::convert_bits() noexcept {
  for (Object& entry : objects_) {
    auto words = entry.object->converters().invert_words_of_bits;
    for (std::size_t i = 0; i < words.size(); ++i)
      words[i] = static_cast<std::uint16_t>(words[i] ^ entry.constant_words_of_bits[i]);
    for (const Place& place : entry.words_of_bits)
      words[place.word] =
          static_cast<std::uint16_t>(words[place.word] ^ (static_cast<unsigned>(place.source.bit()) << place.bit));
    entry.object->process_data().words_of_bits = words;
  }
}

void Wiring::send() noexcept {
  for (Object& entry : objects_) {
    auto& sent = entry.object->process_data().sent;
    for (const Place& place : entry.sent_words)
      sent[place.word] = static_cast<std::uint16_t>(place.source.process_data<std::int16_t>());
    for (const Place& place : entry.sent_double_words)
      ProcessDataImage::set_double_word(sent, place.word,
                                        static_cast<std::uint32_t>(place.source.process_data<std::int32_t>()));
  }
}

}  // namespace drive
