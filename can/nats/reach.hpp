#pragma once

#include <chrono>
#include <string>

#include <tl/expected.hpp>

namespace nats {

/// Whether somebody takes connections at @p port of @p host within @p patience, at any of its addresses. The error
/// is one line.
///
/// Asked again it begins anew, while a connection that is being made asks again after a second, and then after
/// longer and longer: so a way that is whole again is found soon, however long it was not.
[[nodiscard]] tl::expected<void, std::string> reach(const std::string& host, const std::string& port,
                                                    std::chrono::milliseconds patience);

}  // namespace nats
