#include "profidrive/reference/telegram_reference.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "profidrive/telegram/telegrams.hpp"

namespace profidrive {
namespace {

constexpr std::string_view kIntroduction = R"page(# Telegrams

Generated from the tables of profidrive/telegram by the target `update_telegram_reference`; a test compares it with them.

p0922 of a drive object selects a telegram; what that means for its parameters is in [interfaces.md](interfaces.md). "(2)" is a
double word, the upper word first. Words of speed, torque, current and power are relative to p2000 to p2004: 4000h is 100 %,
40000000h in a double word.

)page";

std::string objects_of(const Telegram& telegram) {
  if (telegram.kinds == drive::kControlUnit) return "control unit";
  const std::string kinds = telegram.kinds == drive::kServo    ? "servo"
                            : telegram.kinds == drive::kVector ? "vector"
                                                               : "servo, vector";
  if (telegram.on_any_axis) return kinds;
  return kinds + (telegram.positions ? " with the positioner" : " without the positioner");
}

template <class Word>
std::string names_of(std::span<const Word* const> words) {
  std::string names;
  for (const Word* const word : words)
    names += fmt::format("{}{}{}", names.empty() ? "" : " ", word->name, word->words == 2 ? "(2)" : "");
  return names;
}

std::string telegram_rows() {
  std::string rows = "| p0922 | drive objects | words | p2038 | received | sent |\n|---|---|---|---|---|---|\n";
  for (const Telegram& telegram : telegrams::kAll)
    rows += fmt::format("| {} | {} | {}{}/{} | {} | {} | {} |\n", telegram.number, objects_of(telegram),
                        telegram.has_parameter_channel ? "PKW + " : "", words_of(telegram.received),
                        words_of(telegram.sent), telegram.interface_mode, names_of(telegram.received),
                        names_of(telegram.sent));
  return rows;
}

/// Calls @p visit with every word that a list of a telegram has, each once, and with the telegrams that have it.
template <class Word, class Visit>
void for_each_word(std::span<const Word* const> Telegram::*list, const Visit& visit) {
  std::vector<const Word*> seen;
  for (const Telegram& telegram : telegrams::kAll)
    for (const Word* const word : telegram.*list) {
      if (std::ranges::find(seen, word) != seen.end()) continue;
      seen.push_back(word);
      std::string numbers;
      for (const Telegram& other : telegrams::kAll)
        if (std::ranges::find(other.*list, word) != (other.*list).end())
          numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", other.number);
      visit(*word, numbers);
    }
}

std::string sink_text(const Sink& sink) {
  const std::string input =
      sink.index == 0 ? fmt::format("p{:04}", sink.input) : fmt::format("p{:04}[{}]", sink.input, sink.index);
  if (sink.part == Sink::Part::Bit) return fmt::format("{}: {}", sink.bit, input);
  if (sink.part == Sink::Part::FirstConverter) return fmt::format("{} by r2094: {}", sink.bit, input);
  const std::string_view only = sink.channel == SetpointChannel::With      ? " with setpoint channel"
                                : sink.channel == SetpointChannel::Without ? " without setpoint channel"
                                                                           : "";
  return input + std::string{only};
}

std::string received_rows() {
  std::string rows = "| word | telegrams | leads to (bit: input) |\n|---|---|---|\n";
  for_each_word(&Telegram::received, [&](const ReceivedWord& word, const std::string& numbers) {
    std::string sinks;
    for (const auto& group : word.sinks)
      for (const Sink& sink : group) sinks += (sinks.empty() ? "" : ", ") + sink_text(sink);
    if (sinks.empty()) sinks = word.is_free ? "what is connected to it" : "nothing";
    rows += fmt::format("| {} | {} | {} |\n", word.name, numbers, sinks);
  });
  return rows;
}

std::string bits_text(const StatusBits& bits) {
  std::string text;
  for (std::size_t i = 0; i < bits.size(); ++i)
    if (bits[i].number != 0)
      text += fmt::format("{}{}: {}r{:04}.{}", text.empty() ? "" : ", ", i, bits[i].inverted ? "not " : "",
                          bits[i].number, bits[i].bit);
  return text;
}

std::string shown_text(const SentWord& word) {
  std::string text = word.bits != nullptr ? bits_text(*word.bits)
                     : word.source == 0   ? word.is_free ? "what it is connected to" : "0"
                     : word.index == 0    ? fmt::format("r{:04}", word.source)
                                          : fmt::format("r{:04}[{}]", word.source, word.index);
  if (word.is_free && word.source != 0) text += ", or what it is connected to";
  if (word.shows_synchronised) text += ", 8: the clock of the unit is synchronised";
  if (word.has_sign_of_life) text += ", 12 to 15: sign of life";
  return text;
}

std::string sent_rows() {
  std::string rows = "| word | telegrams | shows (bit: source) |\n|---|---|---|\n";
  for_each_word(&Telegram::sent, [&](const SentWord& word, const std::string& numbers) {
    rows += fmt::format("| {} | {} | {} |\n", word.name, numbers, shown_text(word));
  });
  return rows;
}

}  // namespace

std::string telegram_reference() {
  return fmt::format("{}{}\n## Words that are received\n\n{}\n## Words that are sent\n\n{}", kIntroduction,
                     telegram_rows(), received_rows(), sent_rows());
}

}  // namespace profidrive
