#include "profidrive/telegram/telegram_wiring.hpp"

#include <algorithm>

#include "profidrive/telegram/parameter_numbers.hpp"
#include "profidrive/telegram/telegrams.hpp"

namespace profidrive {
namespace {

using namespace parameter;
using drive::DriveObject;

/// Converters from bits to words (p2080 to p2084).
constexpr std::uint16_t kConverters = 5;

double own(std::uint16_t number, std::size_t position) noexcept {
  return drive::own_source(number, static_cast<std::uint16_t>(position));
}
bool exists(const DriveObject& object, std::uint16_t number, std::size_t index = 0) noexcept {
  return object.parameter(number, index).has_value();
}
void set(DriveObject& object, std::uint16_t number, std::size_t index, double value) noexcept {
  static_cast<void>(object.load(number, index, value));
}

bool has_setpoint_channel(const DriveObject& object) noexcept {
  constexpr std::uint16_t kMainSetpoint = 1070;
  return exists(object, kMainSetpoint);
}
bool applies(const DriveObject& object, const Sink& sink) noexcept {
  if (!exists(object, sink.input, sink.index)) return false;
  return sink.channel == SetpointChannel::Either ||
         (sink.channel == SetpointChannel::With) == has_setpoint_channel(object);
}

/// What an input of the word at @p place is connected to.
double source_of(const Sink& sink, std::size_t place) noexcept {
  switch (sink.part) {
    case Sink::Part::Bit:
      return own(static_cast<std::uint16_t>(kReceivedBits + place), sink.bit);
    case Sink::Part::Word:
      return own(kReceivedWord, place);
    case Sink::Part::DoubleWord:
      return own(kReceivedDoubleWord, place);
    case Sink::Part::FirstConverter:
      break;
  }
  return own(kWordOfConverter, sink.bit);
}

/// Calls @p visit with every word and its place.
template <class Word, class Visit>
void for_each_word(std::span<const Word* const> words, const Visit& visit) {
  std::size_t place = 0;
  for (const Word* const word : words) {
    visit(*word, place);
    place += word->words;
  }
}
template <class Visit>
void for_each_sink(const Telegram& telegram, const Visit& visit) {
  for_each_word(telegram.received, [&](const ReceivedWord& word, std::size_t place) {
    for (const auto& group : word.sinks)
      for (const Sink& sink : group) visit(sink, place);
  });
}

/// The bits of a status word and what inverts them.
void wire_bits(DriveObject& object, const SentWord& word) noexcept {
  const auto input = static_cast<std::uint16_t>(kBitsOfWord + word.converter);
  unsigned inverted = 0;
  for (std::size_t i = 0; i < word.bits->size(); ++i) {
    const StatusBit& bit = (*word.bits)[i];
    const bool is_wired = bit.number != 0 && exists(object, bit.number);
    set(object, input, i, is_wired ? own(bit.number, bit.bit) : 0.0);
    if (bit.inverted) inverted |= 1U << i;
  }
  set(object, kInversion, word.converter, inverted);
  if (word.converted != 0) set(object, kSourceOfConverter, 0, own(word.converted, 0));
}

double shown(const DriveObject& object, const SentWord& word) noexcept {
  if (word.bits != nullptr) return own(kMadeOfBits, word.converter);
  const bool is_wired = word.source != 0 && exists(object, word.source, word.index);
  return is_wired ? own(word.source, word.index) : 0.0;
}

void wire_sent(DriveObject& object, const Telegram& telegram, FreeWords free) noexcept {
  for_each_word(telegram.sent, [&](const SentWord& word, std::size_t place) {
    if (word.is_free && free == FreeWords::Stay) return;
    if (word.bits != nullptr) wire_bits(object, word);
    const double source = shown(object, word);
    set(object, kSentWord, place, word.words == 1 ? source : 0.0);
    set(object, kSentDoubleWord, place, word.words == 1 ? 0.0 : source);
    if (word.words == 1) return;
    set(object, kSentWord, place + 1, 0.0);
    set(object, kSentDoubleWord, place + 1, 0.0);
  });
}

/// Nothing is sent behind the words of @p telegram.
void clear_behind(DriveObject& object, const Telegram& telegram) noexcept {
  for (const std::uint16_t number : {kSentWord, kSentDoubleWord})
    for (std::size_t i = words_of(telegram.sent); exists(object, number, i); ++i) set(object, number, i, 0.0);
}

/// Whether the telegram itself says what the word at @p place is.
bool holds_sent(const Selection& selection, std::size_t place) noexcept {
  bool holds = selection.reach == Reach::Everything;
  for_each_word(selection.telegram->sent, [&](const SentWord& word, std::size_t first) {
    if (place >= first && place < first + word.words) holds = !word.is_free;
  });
  return holds;
}

bool holds_bits(const Telegram& telegram, std::size_t converter) noexcept {
  return std::ranges::any_of(
      telegram.sent, [=](const SentWord* word) { return word->bits != nullptr && word->converter == converter; });
}

bool holds_sink(const DriveObject& object, const Telegram& telegram, std::uint16_t number,
                std::size_t index) noexcept {
  bool holds = number == kSourceOfConverter && index == 0 &&
               std::ranges::any_of(telegram.sent, [](const SentWord* word) { return word->converted != 0; });
  for_each_sink(telegram, [&](const Sink& sink, std::size_t) {
    holds = holds || (sink.input == number && sink.index == index && applies(object, sink));
  });
  return holds;
}

}  // namespace

const Telegram* find_telegram(const DriveObject& object, double number) noexcept {
  const auto* const row = std::ranges::find_if(
      telegrams::kAll, [=](const Telegram& telegram) { return static_cast<double>(telegram.number) == number; });
  if (row == telegrams::kAll.end() || !drive::contains(row->kinds, object.kind())) return nullptr;
  return row->on_any_axis || row->positions == object.context().axis.positioner ? row : nullptr;
}

Selection selection_of(const DriveObject& object) noexcept {
  const double standard = object.kept_value(kSelection).value_or(telegrams::kFreeWords);
  if (const Telegram* const telegram = find_telegram(object, standard)) return {telegram, Reach::Everything};
  const double extended = object.kept_value(kExtendedSelection).value_or(telegrams::kFreeWords);
  return {find_telegram(object, extended), Reach::Words};
}

void wire(DriveObject& object, const Selection& selection, FreeWords free) noexcept {
  const Telegram& telegram = *selection.telegram;
  for_each_sink(telegram, [&](const Sink& sink, std::size_t place) {
    if (applies(object, sink)) set(object, sink.input, sink.index, source_of(sink, place));
  });
  if (selection.reach == Reach::Everything) clear_behind(object, telegram);
  wire_sent(object, telegram, free);
  set(object, kInterfaceMode, 0, telegram.interface_mode);
  set(object, kConnectCanControlword, 0, 0.0);
}

bool is_held(const DriveObject& object, const Selection& selection, std::uint16_t number,
             std::size_t index) noexcept {
  if (selection.telegram == nullptr) return false;
  const Telegram& telegram = *selection.telegram;
  switch (number) {
    case kInterfaceMode:
    case kConnectCanControlword:
      return true;
    case kExtendedSelection:
      return selection.reach == Reach::Everything;
    case kSentWord:
      return holds_sent(selection, index);
    case kSentDoubleWord:
      return holds_sent(selection, index) || holds_sent(selection, index + 1);
    default:
      break;
  }
  if (number >= kBitsOfWord && number < kBitsOfWord + kConverters)
    return holds_bits(telegram, number - std::size_t{kBitsOfWord});
  return holds_sink(object, telegram, number, index);
}

}  // namespace profidrive
