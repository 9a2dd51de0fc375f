#pragma once

#include <array>
#include <string_view>

namespace injection {

/// What an error frame can tell, by the words for it (linux/can/error.h).
inline constexpr auto kErrorClassNames = std::to_array<std::string_view>(
    {"tx-timeout", "lost-arbitration", "overflow", "error-active", "error-warning", "error-passive", "protocol",
     "transceiver", "no-ack", "bus-off", "bus-error", "restarted"});

}  // namespace injection
