#pragma once

#include <string>

namespace nats {

/// A subject that nobody else has, for what is meant for one client.
[[nodiscard]] std::string new_inbox();
/// Letters and digits that nobody else has.
[[nodiscard]] std::string new_nuid();

}  // namespace nats
