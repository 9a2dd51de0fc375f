#include "farm/door/service/answers.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace farm {

namespace {

using nlohmann::json;

/// What the way to a daemon refuses, in words that clients of a control socket know.
struct WordOfWay {
  std::string_view code;
  std::string_view told;
};
constexpr std::array kWordsOfWay{WordOfWay{"no-daemon", "unreachable"}, WordOfWay{"broken-daemon", "unreachable"},
                                 WordOfWay{"silent-daemon", "unreachable"}, WordOfWay{"too-many", "overflow"},
                                 WordOfWay{"too-long", "overflow"}};

std::string_view told_code(std::string_view code) noexcept {
  const auto* const word = std::ranges::find(kWordsOfWay, code, &WordOfWay::code);
  return word != kWordsOfWay.end() ? word->told : code;
}

/// A text that is not UTF-8 (a name from a file, say) must not end the conversation.
std::string text_of_answer(json answer, const json& id) {
  if (!id.is_null()) answer["id"] = id;
  return answer.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

std::string answer_text(const json& id, const gateway::Answer& answer) {
  if (answer) return text_of_answer({{"result", *answer}}, id);
  const gateway::Error& error = answer.error();
  json object = error.details.is_object() ? error.details : json::object();
  object["code"] = told_code(error.code);
  object["message"] = error.message;
  return text_of_answer({{"error", std::move(object)}}, id);
}

}  // namespace farm
