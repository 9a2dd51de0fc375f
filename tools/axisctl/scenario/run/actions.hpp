#pragma once

#include <string>

#include <tl/expected.hpp>

#include "tools/axisctl/scenario/run/context.hpp"

namespace scenario {

/// What came of a step: what has happened, or what was wrong, in one line.
using Outcome = tl::expected<std::string, std::string>;

/// Does what @p step says; not for never and always, which go on beside other steps.
[[nodiscard]] Outcome act(Context& context, const Step& step);

/// Waits until @p condition holds, for at most @p limit.
[[nodiscard]] Outcome wait_for(Context& context, const Condition& condition, canopen::Duration limit);

/// @p milliseconds of a step.
[[nodiscard]] canopen::Duration milliseconds(double milliseconds) noexcept;

}  // namespace scenario
