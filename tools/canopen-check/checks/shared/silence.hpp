#pragma once

#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// How long a server is left waiting for the next request of a transfer. The time after which it aborts is its
/// own.
inline constexpr canopen::Duration kSilence = std::chrono::seconds{2};

/// What comes of kSilence, or until the server has aborted, in the middle of an upload: of the silence that
/// listen_alone() has kept, else of one of its own. A step has begun with its traffic.
[[nodiscard]] const Silence& silence_of_client(Context& context);

/// Every frame that fulfils @p condition during @p span, in which the node is asked for nothing. That is the
/// beginning of the silence of sdo.silent-client if that check is still to come; a node that is gone behind it is
/// reset. What is wrong then has to be looked at once more with Session::collect().
[[nodiscard]] std::vector<TimedFrame> listen_alone(Context& context, const Condition& condition,
                                                   canopen::Duration span);

}  // namespace conformance
