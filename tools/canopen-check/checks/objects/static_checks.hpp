#pragma once

#include <span>
#include <string>
#include <vector>

#include "eds/document/finding.hpp"
#include "tools/canopen-check/core/check.hpp"

namespace conformance {

/// The checks of an EDS alone, those of `edstool lint`: "static.duplicate-key" and so on.
[[nodiscard]] std::span<const Check> static_checks();

/// What came of them, given the @p findings in all files. An error is a finding of its check, a warning a note.
[[nodiscard]] std::vector<CheckResult> judge_files(std::span<const eds::Finding> findings);

}  // namespace conformance
