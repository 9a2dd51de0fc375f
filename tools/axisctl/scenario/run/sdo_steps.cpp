#include "tools/axisctl/scenario/run/sdo_steps.hpp"

#include <functional>
#include <optional>

#include <fmt/format.h>

#include "eds/description/description.hpp"
#include "tools/axisctl/scenario/run/observation.hpp"
#include "tools/canopen-check/core/sdo_client.hpp"

namespace scenario {
namespace {

using conformance::SdoAnswer;
using nlohmann::json;

/// Identifiers of the first SDO server (CiA 301, 7.3.3), and where those of server n stand.
constexpr std::uint32_t kRequest = 0x600, kResponse = 0x580;
constexpr std::uint32_t kServers = 0x1200;

struct Entry {
  std::uint16_t index;
  std::uint8_t sub_index;
};
Entry entry_of(const json& keys, const char* action) {
  const std::string text = keys.at(action).get<std::string>();
  constexpr int kHexadecimal = 16;
  constexpr std::size_t kSub = 5;
  const auto index = static_cast<std::uint16_t>(std::stoul(text.substr(0, 4), nullptr, kHexadecimal));
  const auto sub = text.size() > kSub ? std::stoul(text.substr(kSub), nullptr, kHexadecimal) : 0UL;
  return {index, static_cast<std::uint8_t>(sub)};
}

struct Identifiers {
  std::uint32_t request, response;
};
/// What the unit itself says of the server that is meant.
tl::expected<Identifiers, std::string> identifiers_of(Context& context, const json& keys) {
  Unit& unit = context.stations.unit(keys);
  const std::uint32_t server = keys.value("server", 1U);
  if (server == 1) return Identifiers{kRequest + unit.plan.node_id, kResponse + unit.plan.node_id};
  Identifiers identifiers{};
  for (auto [sub, identifier] : {std::pair{1, &identifiers.request}, {2, &identifiers.response}}) {
    const auto told = ask(unit, "object.read", {{"index", kServers + server - 1}, {"sub_index", sub}});
    if (!told) return tl::unexpected{told.error()};
    *identifier = told->value("value", 0U);
  }
  return identifiers;
}

/// The number that `value` of a step or `abort` says.
std::optional<std::int64_t> number_of(const json& value) {
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (!value.is_string()) return std::nullopt;
  try {
    std::size_t used = 0;
    const auto& text = value.get_ref<const std::string&>();
    const std::int64_t number = std::stoll(text, &used, 0);
    if (used == text.size()) return number;
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return std::nullopt;
}

/// The value as it is compared: a number up to eight bytes, else a text.
json value_of(const SdoAnswer& answer) {
  constexpr std::size_t kNumber = 8;
  const bool is_text = !answer.expedited && answer.data.size() > 4;
  if (!is_text && answer.data.size() <= kNumber) return answer.number();
  return std::string{answer.data.begin(), answer.data.end()};
}

std::string unexpected_answer(const SdoAnswer& answer, std::string_view expected) {
  return fmt::format("expected {}, got {}", expected, to_text(answer));
}

Outcome judge(const SdoAnswer& answer, const json& keys) {
  if (keys.contains("abort")) {
    const auto code = number_of(keys.at("abort"));
    if (answer.aborted() && code && answer.abort_code == static_cast<std::uint64_t>(*code)) return to_text(answer);
    return tl::unexpected{unexpected_answer(answer, "abort " + keys.at("abort").get<std::string>())};
  }
  const std::string wanted = keys.value("answer", std::string{});
  if (wanted == "none") {
    if (answer.kind == SdoAnswer::Kind::Silent) return to_text(answer);
    return tl::unexpected{unexpected_answer(answer, "no answer")};
  }
  if (wanted == "malformed") {
    if (!answer.problem.empty()) return to_text(answer);
    return tl::unexpected{unexpected_answer(answer, "an answer that is none of the protocol")};
  }
  if (!answer.done()) return tl::unexpected{unexpected_answer(answer, "an answer")};
  return std::string{};
}

/// Runs @p transfer with a client of the server that is meant.
Outcome transfer(Context& context, const json& keys,
                 const std::function<Outcome(conformance::SdoClient& client)>& run) {
  const auto identifiers = identifiers_of(context, keys);
  if (!identifiers) return tl::unexpected{identifiers.error()};
  conformance::Session session{context.bench, context.stations.unit(keys).plan.node_id};
  conformance::SdoClient client{session, identifiers->request, identifiers->response,
                                milliseconds(keys.value("within_ms", kUsualWait))};
  return run(client);
}

}  // namespace

Outcome read_entry(Context& context, const json& keys) {
  const Entry entry = entry_of(keys, "read");
  return transfer(context, keys, [&](conformance::SdoClient& client) -> Outcome {
    const SdoAnswer answer = client.upload(entry.index, entry.sub_index);
    Outcome outcome = judge(answer, keys);
    if (!outcome || !outcome->empty()) return outcome;
    const json value = value_of(answer);
    json wanted = keys;
    if (value.is_number() && keys.contains("is"))
      if (const auto number = number_of(keys.at("is"))) wanted["is"] = *number;
    if (is_wanted(value, wanted)) return value.dump();
    return tl::unexpected{fmt::format("the value is {}", value.dump())};
  });
}

Outcome write_entry(Context& context, const json& keys) {
  const Entry entry = entry_of(keys, "write");
  const auto number = number_of(keys.at("value"));
  std::vector<std::uint8_t> bytes;
  constexpr std::size_t kUsualBytes = 4;
  if (number)
    bytes = eds::little_endian(static_cast<std::uint64_t>(*number), keys.value("bytes", kUsualBytes));
  else if (keys.at("value").is_string())
    bytes.assign(keys.at("value").get_ref<const std::string&>().begin(),
                 keys.at("value").get_ref<const std::string&>().end());
  return transfer(context, keys, [&](conformance::SdoClient& client) -> Outcome {
    return judge(client.download(entry.index, entry.sub_index, bytes), keys);
  });
}

}  // namespace scenario
