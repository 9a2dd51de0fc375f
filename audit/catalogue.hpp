#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "audit/base/rule.hpp"
#include "audit/base/topic.hpp"

namespace audit {

struct Circumstances;

/// Rules that belong together: their ids begin with `word`.
struct RuleGroup {
  std::string_view word;
  std::string_view title;
  std::span<const Rule* const> rules;
};

/// All rules, in the order of the docs.
[[nodiscard]] std::span<const RuleGroup> rule_groups() noexcept;
/// The rule @p id; nullptr if there is none.
[[nodiscard]] const Rule* find_rule(std::string_view id) noexcept;

/// Everything that looks at frames but SDO itself.
[[nodiscard]] std::vector<std::unique_ptr<Topic>> make_topics(const Circumstances& circumstances);

}  // namespace audit
