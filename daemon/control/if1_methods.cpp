// Process data of IF1.
#include <array>
#include <vector>

#include <fmt/format.h>

#include "daemon/control/arguments.hpp"
#include "daemon/control/handlers.hpp"
#include "daemon/instance/instance.hpp"
#include "profidrive/telegram/telegrams.hpp"
#include "text/number.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;
using Words = std::vector<std::uint16_t>;

constexpr std::string_view kReceived = "received";
constexpr int kHexadecimal = 16;
constexpr std::size_t kDigits = 4;  ///< of a word

std::optional<std::uint16_t> word_in(std::string_view digits) noexcept {
  return text::integer<std::uint16_t>(digits, kHexadecimal);
}

tl::unexpected<control::Error> not_words(const json& value) {
  return tl::unexpected{
      unexpected_value(kReceived, "hexadecimal words such as \"047E\", four digits each in one text", &value)};
}

/// All words in one text.
Taken<Words> words_in(const json& value, std::string_view text) {
  Words words;
  if (text.size() % kDigits != 0) return not_words(value);
  for (std::size_t i = 0; i < text.size(); i += kDigits) {
    const auto word = word_in(text.substr(i, kDigits));
    if (!word) return not_words(value);
    words.push_back(*word);
  }
  return words;
}

Taken<Words> words_of(const json& params) {
  const json* const value = Arguments{params}.find(kReceived);
  if (value == nullptr) return Words{};
  if (value->is_string()) return words_in(*value, value->get<std::string>());
  Words words;
  const bool is_whole = value->size() == 1 && value->front().is_string();
  if (is_whole && value->front().get_ref<const std::string&>().size() > kDigits)
    return words_in(*value, value->front().get<std::string>());
  for (const json& element : *value) {
    const auto word =
        element.is_string() ? word_in(element.get<std::string>()) : std::optional{element.get<std::uint16_t>()};
    if (!word) return not_words(*value);
    words.push_back(*word);
  }
  return words;
}

std::string text_of(std::span<const std::uint16_t> words) {
  std::string text;
  for (const std::uint16_t word : words) text += fmt::format("{:04X}", word);
  return text;
}

Outcome exchange(const Call& call, const json& params) {
  const auto object = params.at("do").get<std::uint8_t>();
  const auto words = words_of(params);
  if (!words) return tl::unexpected{words.error()};
  if (!call.instance.device().is_on()) return tl::unexpected{unit_is_off()};
  profidrive::Interface& if1 = call.instance.if1();
  if (!if1.has(object))
    return refuse(ErrorCode::NotFound,
                  fmt::format("do: drive object {} exchanges no process data on IF1: {}", object,
                              if1.is_assigned() ? "there is no such drive object, or it has none"
                                                : "p8839 assigns it nothing"));
  call.instance.device().tell_time(call.now);
  if (words->empty())
    if1.touch(object);
  else
    if1.receive(object, *words);
  const auto sent = if1.sent(object).first(if1.words_to_send(object));
  const profidrive::Telegram* const telegram = if1.selection(object).telegram;
  return json{{"do", object},
              {"telegram", telegram != nullptr ? telegram->number : profidrive::telegrams::kFreeWords},
              {"sent", std::vector<std::uint16_t>(sent.begin(), sent.end())},
              {"text", text_of(sent)}};
}

constexpr std::array kIf1Handlers{
    Handler{"if1.exchange", &exchange},
};

}  // namespace

std::span<const Handler> if1_handlers() noexcept {
  return kIf1Handlers;
}

}  // namespace axisd
