#pragma once

#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// Why the tester must not write @p entry under @p settings; null where it may. Storage needs --allow-store, what
/// moves a drive --allow-motion; program download and the deletion of the error history are the user's.
[[nodiscard]] const char* write_refusal(const eds::EntryFacts& entry, const Settings& settings) noexcept;

}  // namespace conformance
