#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "audit/base/findings.hpp"

namespace audit_tool {

/// A finding that its user knows of.
struct KnownFinding {
  std::string rule{};
  std::optional<std::uint8_t> node{};  ///< nothing: of any node
  std::string text{};                  ///< that stands in the words of the finding; empty: whatever they are
  std::string reason{}, source{};
  bool seen = false;
};

/// A list of them.
class KnownFindings {
 public:
  /// Reads the JSON list @p text of {rule, reason, source} and, where not all findings of the rule are meant,
  /// node and text. The error says what was wrong, where, and what was expected.
  [[nodiscard]] static tl::expected<KnownFindings, std::string> parse(std::string_view text);

  /// The first reason why @p finding is known; nullptr if it is not. Notes that it was seen.
  [[nodiscard]] const std::string* find(const audit::Finding& finding);
  /// Those that no finding has shown.
  [[nodiscard]] std::vector<const KnownFinding*> unseen() const;

 private:
  std::vector<KnownFinding> all_;
};

}  // namespace audit_tool
