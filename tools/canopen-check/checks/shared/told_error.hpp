#pragma once

#include "tools/canopen-check/checks/shared/provocation.hpp"

namespace conformance {

/// The error that the checks of emergency messages share: provoked in one of kWays, looked at and ended, once in a
/// run. A step has begun with its traffic. Null, and the check is skipped, if the node sends no emergency message.
[[nodiscard]] const ToldError* told_error(Context& context);
/// Resets the node, which ends what lasts, and prepares @p error anew. Nothing, and the check is skipped, if that
/// is not possible.
[[nodiscard]] std::optional<Provoked> prepare_again(Context& context, const ToldError& error);

}  // namespace conformance
