#include "drive/wiring.hpp"

#include <algorithm>
#include <bit>
#include <variant>

namespace drive {
namespace {

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

/// Whether two numbers are the same to the last bit.
bool same(double a, double b) noexcept {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

Wiring::Wiring(DriveUnit& unit) : unit_{unit} {
  unit.for_each_object([this](DriveObject& object) {
    objects_.push_back({.object = &object,
                        .images = {ImageLinks{object.if1(), object.if1_converters()},
                                   ImageLinks{object.process_data(), object.converters()}}});
  });
  for (Object& entry : objects_) reserve(entry);
  for (auto* const list : {&words_to_convert_, &bits_to_convert_, &to_send_})
    list->reserve(objects_.size() * std::tuple_size_v<decltype(Object::images)>);
}

/// Makes room for all inputs, so that nothing is allocated later.
void Wiring::reserve(Object& entry) {
  std::size_t bits_of_words = 0;  // of both interfaces, which are alike
  for_each_input(*entry.object, [&](const ParameterRow& row, const auto& input) {
    if constexpr (std::is_same_v<std::decay_t<decltype(input)>, ImageInput>)
      bits_of_words += input.sink == ImageSink::BitOfWord ? row.count : 0U;
    else
      inputs_of(entry, input.block).count += row.count;
  });
  for (Inputs& inputs : entry.blocks) {
    for (auto* const bits : {&inputs.bits, &inputs.constant_bits}) bits->reserve(inputs.count);
    for (auto* const values : {&inputs.values, &inputs.constant_values}) values->reserve(inputs.count);
    inputs.words.reserve(inputs.count);
  }
  for (ImageLinks& image : entry.images) image.reserve(bits_of_words);
}

Wiring::Inputs& Wiring::inputs_of(Object& entry, BlockId block) {
  const auto found = std::ranges::find(entry.blocks, block, &Inputs::block);
  return found != entry.blocks.end() ? *found : entry.blocks.emplace_back(Inputs{.block = block});
}

void Wiring::connect() noexcept {
  if (valid_) return;
  valid_ = true;
  for (Object& entry : objects_) connect(entry);
  list_images();
}

void Wiring::list_images() noexcept {
  for (auto* const list : {&words_to_convert_, &bits_to_convert_, &to_send_}) list->clear();
  for (Object& entry : objects_)
    for (ImageLinks& image : entry.images) {
      if (image.has_words()) words_to_convert_.push_back(&image);
      if (image.has_bits()) bits_to_convert_.push_back(&image);
      if (image.sends()) to_send_.push_back(&image);
    }
}

// The generic lambda calls members.
// NOLINTNEXTLINE(readability-convert-member-functions-to-static)
void Wiring::connect(Object& entry) noexcept {
  for (Inputs& inputs : entry.blocks) {
    for (auto* const bits : {&inputs.bits, &inputs.constant_bits}) bits->clear();
    for (auto* const values : {&inputs.values, &inputs.constant_values}) values->clear();
    inputs.is_taken = false;
  }
  for (ImageLinks& image : entry.images) image.clear();
  for_each_input(*entry.object, [&](const ParameterRow& row, const auto& input) { connect(entry, row, input); });
  for (Inputs& inputs : entry.blocks) group(inputs);
  for (ImageLinks& image : entry.images) image.finish();
}

SignalSource Wiring::source(const DriveObject& object, const ParameterRow& row, std::size_t index) const noexcept {
  return {unit_, object, static_cast<std::uint32_t>(object.read(row.number, index).value_or(0.0))};
}

void Wiring::connect(Object& entry, const ParameterRow& row, const BitInput& input) noexcept {
  Inputs& inputs = inputs_of(entry, input.block);
  void* const block = entry.object->block(input.block);
  for (std::size_t i = 0; i < row.count; ++i) {
    add(inputs, {&input.member(block, i), source(*entry.object, row, i)});
  }
}

/// Binectors of the same word stand side by side.
void Wiring::add(Inputs& inputs, const BitLink& link) noexcept {
  if (link.source.is_constant()) return inputs.constant_bits.push_back(link);
  const auto last = std::find_if(inputs.bits.rbegin(), inputs.bits.rend(),
                                 [&](const BitLink& other) { return other.source.shares_word(link.source); });
  inputs.bits.insert(last != inputs.bits.rend() ? last.base() : inputs.bits.end(), link);
}

void Wiring::group(Inputs& inputs) noexcept {
  inputs.words.clear();
  for (std::size_t i = 0; i < inputs.bits.size(); ++i) {
    const SignalSource& source = inputs.bits[i].source;
    if (i == 0 || !source.shares_word(inputs.bits[i - 1].source)) inputs.words.push_back({source, i});
    ++inputs.words.back().count;
  }
}

void Wiring::connect(Object& entry, const ParameterRow& row, const ValueInput& input) noexcept {
  Inputs& inputs = inputs_of(entry, input.block);
  void* const block = entry.object->block(input.block);
  const double of_one = row_of(input.quantity).of_one;
  const bool is_plain = of_one > 0.0;
  const double full = is_plain ? of_one : reference(*entry.object, input.quantity);
  for (std::size_t i = 0; i < row.count; ++i) {
    SignalSource from = source(*entry.object, row, i);
    if (is_plain) from.take_plain();
    (from.is_constant() ? inputs.constant_values : inputs.values).push_back({&input.member(block, i), from, full});
  }
}

void Wiring::connect(Object& entry, const ParameterRow& row, const ImageInput& input) noexcept {
  ImageLinks& image = entry.images[static_cast<std::size_t>(input.interface)];
  for (std::size_t i = 0; i < row.count; ++i) image.connect(input, i, source(*entry.object, row, i));
}

std::span<const Wiring::BitLink> Wiring::bits_of(const Inputs& inputs, const Word& word) noexcept {
  return std::span{inputs.bits}.subspan(word.first, word.count);
}

void Wiring::take(const DriveObject& object, BlockId block) noexcept {
  for (Inputs& inputs : entry_of(object).blocks)
    if (inputs.block == block) return take(inputs);
}

void Wiring::add_group(const DriveObject& object, std::span<const BlockId> blocks) {
  Object& entry = entry_of(object);
  Group group{.first = entry.groups.empty() ? 0 : entry.groups.back().first + entry.groups.back().count};
  for (const BlockId block : blocks) {
    const auto place = entry.blocks.begin() + static_cast<std::ptrdiff_t>(group.first + group.count);
    const auto found =
        std::find_if(place, entry.blocks.end(), [=](const Inputs& inputs) { return inputs.block == block; });
    if (found == entry.blocks.end()) continue;
    std::iter_swap(place, found);
    ++group.count;
  }
  entry.groups.push_back(group);
}

void Wiring::take_group(const DriveObject& object, std::size_t group) noexcept {
  Object& entry = entry_of(object);
  for (Inputs& inputs : std::span{entry.blocks}.subspan(entry.groups[group].first, entry.groups[group].count))
    take(inputs);
}

inline void Wiring::take(Inputs& inputs) noexcept {
  if (!inputs.is_taken) return take_all(inputs);
  if (!inputs.words.empty() || !inputs.values.empty()) take_new(inputs);
}

void Wiring::take_all(Inputs& inputs) noexcept {
  inputs.is_taken = true;
  for (const BitLink& link : inputs.constant_bits) *link.input = link.source.bit();
  for (const ValueLink& link : inputs.constant_values) *link.input = link.source.value(link.full);
  for (Word& word : inputs.words) {
    word.taken = word.source.word();
    for (const BitLink& link : bits_of(inputs, word)) *link.input = link.source.bit(word.taken);
  }
  for (ValueLink& link : inputs.values) {
    link.taken = link.source.number();
    *link.input = link.source.value(link.taken, link.full);
  }
}

/// What a source brings changes with its number alone.
void Wiring::take_new(Inputs& inputs) noexcept {
  for (Word& word : inputs.words) {
    const double now = word.source.word();
    if (same(now, word.taken)) continue;
    word.taken = now;
    for (const BitLink& link : bits_of(inputs, word)) *link.input = link.source.bit(now);
  }
  for (ValueLink& link : inputs.values) {
    const double now = link.source.number();
    if (same(now, link.taken)) continue;
    link.taken = now;
    *link.input = link.source.value(now, link.full);
  }
}

bool Wiring::changed(const DriveObject& object, std::size_t group) const noexcept {
  const Object& entry = objects_[object.number() - std::size_t{1}];
  const Group& place = entry.groups[group];
  return std::ranges::any_of(std::span{entry.blocks}.subspan(place.first, place.count), [](const Inputs& inputs) {
    return inputs.is_taken ? has_new(inputs) : is_other(inputs);
  });
}

/// Whether an input has another value than what it is connected to.
bool Wiring::is_other(const Inputs& inputs) noexcept {
  const auto bit = [](const BitLink& link) { return link.source.bit() != *link.input; };
  const auto value = [](const ValueLink& link) { return link.source.value(link.full) != *link.input; };
  return std::ranges::any_of(inputs.constant_bits, bit) || std::ranges::any_of(inputs.bits, bit) ||
         std::ranges::any_of(inputs.constant_values, value) || std::ranges::any_of(inputs.values, value);
}

/// The same of inputs that hold what was last taken.
bool Wiring::has_new(const Inputs& inputs) noexcept {
  const auto word = [&](const Word& from) {
    const double now = from.source.word();
    return !same(now, from.taken) && std::ranges::any_of(bits_of(inputs, from), [=](const BitLink& link) {
      return link.source.bit(now) != *link.input;
    });
  };
  const auto value = [](const ValueLink& link) {
    const double now = link.source.number();
    return !same(now, link.taken) && link.source.value(now, link.full) != *link.input;
  };
  return std::ranges::any_of(inputs.words, word) || std::ranges::any_of(inputs.values, value);
}

void Wiring::convert_words() noexcept {
  for (ImageLinks* const image : words_to_convert_) image->convert_words();
}

void Wiring::convert_bits() noexcept {
  for (ImageLinks* const image : bits_to_convert_) image->convert_bits();
}

void Wiring::send() noexcept {
  for (ImageLinks* const image : to_send_) image->send();
}

}  // namespace drive
