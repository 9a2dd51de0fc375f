#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "injection/language/fault.hpp"
#include "injection/language/trigger.hpp"

namespace injection {

/// What is wrong with a fault that somebody has written.
struct Problem {
  std::string key{};  ///< empty: the whole
  std::string expected{};
  std::string got{};            ///< as JSON; empty: nothing is there
  bool is_unknown_key = false;  ///< `expected` names those that are known

  /// "kind: expected one of ..., got \"sdo.lat\"".
  std::string message() const;
};

/// The fault that @p value says, of one of @p kinds, which outlive it.
tl::expected<Fault, Problem> read_fault(const nlohmann::json& value, std::span<const Kind> kinds);
/// The same, written as words: "bus.drop id=185 after=10 until=10 heartbeat".
tl::expected<Fault, Problem> read_fault_words(std::string_view words, std::span<const Kind> kinds);

/// @p fault as read_fault() reads it; identifiers, indices and codes as hexadecimal texts.
nlohmann::json json_of(const Fault& fault);
/// What has come of a fault: state, events, opportunities, hits, hit_at.
nlohmann::json json_of(const Trigger& trigger);
/// What there is to say of @p kind: kind, summary, nature, event, arguments with their bounds.
nlohmann::json json_of(const Kind& kind);

/// What a value of @p row may be, for messages and pages.
std::string rule_of(const ArgumentRow& row);
/// The keys that a fault of @p kind can have.
std::vector<std::string_view> keys_of(const Kind& kind);

}  // namespace injection
