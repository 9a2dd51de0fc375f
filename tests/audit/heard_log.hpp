#pragma once

#include <string_view>
#include <vector>

#include "audit/auditor.hpp"

namespace audit_test {

/// The frames of @p log, a line each as `candump -L` writes them; a test fails for a line that is none.
[[nodiscard]] std::vector<audit::Heard> frames_of(std::string_view log);

/// What an auditor finds in @p log with @p circumstances.
[[nodiscard]] audit::Findings findings_of(std::string_view log, audit::Circumstances circumstances = {});

/// The ids of the rules that @p findings are about, each once, in their order.
[[nodiscard]] std::vector<std::string_view> rules_of(const audit::Findings& findings);

}  // namespace audit_test
