#pragma once

#include "can/userbus/protocol.hpp"

namespace userbus {

/// Runs `HUB --on-demand --path PATH [--bitrate N] [--time T]` and waits until it says that the path is served: in
/// a new session, descriptors 0 to 2 on /dev/null and all others closed, without LD_PRELOAD, with default signals.
/// The
/// @p bit_rate is digits as read_bit_rate() takes them, nullptr: as the bus is. The
/// caller's wait(2) and SIGCHLD see nothing of it. StartStatus::Failed with errno ENOENT if @p hub cannot be
/// executed, with EINTR if somebody ended it while it started.
StartStatus start_hub(const char* hub, const char* path, const char* bit_rate = nullptr,
                      const char* time = nullptr) noexcept;

}  // namespace userbus
