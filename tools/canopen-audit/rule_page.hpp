#pragma once

#include <string>

namespace audit_tool {

/// Every rule, a line each.
[[nodiscard]] std::string rules_as_text();
/// Every rule as docs/reference/audit-rules.md has it: with frames that break it, why it matters and how to mend
/// it.
[[nodiscard]] std::string rules_as_markdown();

}  // namespace audit_tool
