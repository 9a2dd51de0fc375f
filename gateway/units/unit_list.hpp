#pragma once

#include "gateway/units/daemon_client.hpp"

namespace gateway {

/// Asks @p client for its units; @p on_answer is told what `units` gives, with all of them however many lines they
/// take.
void ask_for_units(DaemonClient& client, OnAnswer on_answer);

}  // namespace gateway
