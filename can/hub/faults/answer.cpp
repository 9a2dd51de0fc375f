#include "can/hub/faults/answer.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "can/userbus/protocol.hpp"
#include "injection/json/fault_json.hpp"
#include "injection/json/when_rows.hpp"
#include "injection/kinds/bus_kinds.hpp"

namespace hub::faults {

namespace {

using nlohmann::json;

/// Bytes of the rest of an answer, beside what is listed.
constexpr std::size_t kFrame = 512;
/// Bytes of a list.
constexpr std::size_t kRoom = userbus::kLongestMessage - kFrame;
/// Characters of what was said that a message repeats.
constexpr std::size_t kLongestQuote = 60;

struct Call {
  Faults& faults;
  const json& params;
  canopen::TimePoint now;
};

using Result = tl::expected<json, std::string>;

std::string printed(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// The number at @p key; nothing if there is none, one line if it is none.
tl::expected<std::optional<std::uint32_t>, std::string> number_at(const json& params, const char* key) {
  const auto given = params.find(key);
  if (given == params.end()) return std::nullopt;
  const auto number = injection::whole_number(*given);
  if (!number || *number > UINT32_MAX)
    return tl::unexpected{
        fmt::format("{}: expected a whole number, got {}", key, printed(*given).substr(0, kLongestQuote))};
  return static_cast<std::uint32_t>(*number);
}

/// Of @p rows those behind the first "behind" of them, as many as there is room for.
Result page(const Call& call, const char* name, const json& rows) {
  const auto behind = number_at(call.params, "behind");
  if (!behind) return tl::unexpected{behind.error()};
  json told = json::array();
  std::size_t size = 0;
  std::size_t next = behind->value_or(0);
  for (; next < rows.size(); ++next) {
    size += printed(rows[next]).size() + 1;
    if (size > kRoom) break;
    told.push_back(rows[next]);
  }
  return json{{name, std::move(told)}, {"rows", rows.size()}};
}

Result add(const Call& call) {
  const auto said = call.params.find("fault");
  if (said == call.params.end())
    return tl::unexpected{std::string{"fault: expected an object or words, got nothing"}};
  const auto number = call.faults.inject(*said, call.now);
  if (!number) return tl::unexpected{number.error()};
  return json{{"id", *number}};
}

Result list(const Call& call) {
  auto told = page(call, "faults", call.faults.list(call.now));
  if (told) (*told)["lost"] = call.faults.lost();
  return told;
}

Result remove(const Call& call) {
  const auto number = number_at(call.params, "id");
  if (!number) return tl::unexpected{number.error()};
  const std::size_t count = call.faults.take_back(*number);
  if (*number && count == 0)
    return tl::unexpected{fmt::format("id: expected the number of a fault, got {}", **number)};
  return json{{"removed", count}};
}

Result tell_kinds(const Call& call) {
  json rows = json::array();
  for (const injection::Kind& kind : injection::bus_kinds()) rows.push_back(injection::json_of(kind));
  return page(call, "kinds", rows);
}

struct Method {
  std::string_view name;
  Result (*run)(const Call& call);
};

constexpr std::array kMethods{Method{"inject.add", &add}, Method{"inject.list", &list},
                              Method{"inject.remove", &remove}, Method{"inject.kinds", &tell_kinds}};

Result carry_out(Faults& faults, std::string_view request, canopen::TimePoint now) {
  const json asked = json::parse(request, nullptr, false);
  const std::string name = asked.is_object() && asked.contains("method") ? printed(asked["method"]) : "nothing";
  const auto is_named = [&](const Method& method) { return name == fmt::format("\"{}\"", method.name); };
  const auto* const method = std::ranges::find_if(kMethods, is_named);
  if (method == kMethods.end())
    return tl::unexpected{
        fmt::format("method: expected one of inject.add, inject.list, inject.remove, inject.kinds, got {}",
                    name.substr(0, kLongestQuote))};
  const json params = asked.value("params", json::object());
  if (!params.is_object())
    return tl::unexpected{
        fmt::format("params: expected an object, got {}", printed(params).substr(0, kLongestQuote))};
  return method->run({faults, params, now});
}

}  // namespace

Answer answer(Faults& faults, std::string_view request, canopen::TimePoint now) {
  const Result result = carry_out(faults, request, now);
  if (result) return {.error = 0, .text = printed(*result)};
  return {.error = EINVAL, .text = printed({{"message", result.error()}})};
}

}  // namespace hub::faults
