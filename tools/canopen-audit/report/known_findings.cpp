#include "tools/canopen-audit/report/known_findings.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "audit/catalogue.hpp"

namespace audit_tool {
namespace {

constexpr unsigned kHighestNode = 127;

using Read = tl::expected<KnownFinding, std::string>;

/// @p value as JSON in one line, as far as it is short.
std::string dumped(const nlohmann::json& value) {
  constexpr std::size_t kLongest = 60;
  const std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
}

/// The text of @p key in @p item; empty if it is not there and need not be. The error says what was expected.
tl::expected<std::string, std::string> text_of(const nlohmann::json& item, const char* key, std::size_t position,
                                               bool is_needed) {
  const auto at = item.find(key);
  if (at == item.end() && !is_needed) return std::string{};
  if (at != item.end() && at->is_string() && !at->get_ref<const std::string&>().empty())
    return at->get<std::string>();
  return tl::unexpected{
      fmt::format("/{}/{}: expected a text, got {}", position, key, at == item.end() ? "nothing" : dumped(*at))};
}

tl::expected<std::optional<std::uint8_t>, std::string> node_of(const nlohmann::json& item, std::size_t position) {
  const auto at = item.find("node");
  if (at == item.end()) return std::nullopt;
  if (at->is_number_unsigned() && at->get<std::uint64_t>() <= kHighestNode)
    return static_cast<std::uint8_t>(at->get<std::uint64_t>());
  return tl::unexpected{
      fmt::format("/{}/node: expected 0 (of no one) or a node-ID to 127, got {}", position, dumped(*at))};
}

/// What is said of a key of @p item that a known finding has not, as of one that is misspelled; else empty.
std::string unknown_key(const nlohmann::json& item, std::size_t position) {
  constexpr std::array kKeys{"rule", "node", "text", "reason", "source"};
  for (const auto& [key, value] : item.items())
    if (std::ranges::find(kKeys, key) == kKeys.end())
      return fmt::format("/{}: expected rule, reason, source, node or text, got the key {}", position,
                         dumped(key));
  return "";
}

Read parse_item(const nlohmann::json& item, std::size_t position) {
  if (!item.is_object())
    return tl::unexpected{fmt::format("/{}: expected an object, got {}", position, dumped(item))};
  if (std::string message = unknown_key(item, position); !message.empty()) return tl::unexpected{message};
  struct Key {
    const char* name;
    std::string KnownFinding::*member;
    bool is_needed;
  };
  KnownFinding known;
  for (const Key& key : {Key{"rule", &KnownFinding::rule, true}, Key{"reason", &KnownFinding::reason, true},
                         Key{"source", &KnownFinding::source, true}, Key{"text", &KnownFinding::text, false}}) {
    auto text = text_of(item, key.name, position, key.is_needed);
    if (!text) return tl::unexpected{text.error()};
    known.*key.member = *std::move(text);
  }
  if (audit::find_rule(known.rule) == nullptr)
    return tl::unexpected{fmt::format("/{}/rule: expected a rule (see --list), got \"{}\"", position, known.rule)};
  const auto node = node_of(item, position);
  if (!node) return tl::unexpected{node.error()};
  known.node = *node;
  return known;
}

}  // namespace

tl::expected<KnownFindings, std::string> KnownFindings::parse(std::string_view text) {
  const nlohmann::json list = nlohmann::json::parse(text, nullptr, false);
  if (!list.is_array()) return tl::unexpected{std::string{"expected a JSON list of {rule, reason, source}"}};
  KnownFindings known;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Read item = parse_item(list[i], i);
    if (!item) return tl::unexpected{item.error()};
    known.all_.push_back(*std::move(item));
  }
  return known;
}

const std::string* KnownFindings::find(const audit::Finding& finding) {
  const std::string* reason = nullptr;
  for (KnownFinding& known : all_) {
    const bool is_meant = known.rule == finding.rule->id && known.node.value_or(finding.node) == finding.node &&
                          finding.text.find(known.text) != std::string::npos;
    if (!is_meant) continue;
    known.seen = true;
    if (reason == nullptr) reason = &known.reason;
  }
  return reason;
}

std::vector<const KnownFinding*> KnownFindings::unseen() const {
  std::vector<const KnownFinding*> unseen;
  for (const KnownFinding& known : all_)
    if (!known.seen) unseen.push_back(&known);
  return unseen;
}

}  // namespace audit_tool
