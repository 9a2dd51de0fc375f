#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "can/nats/server.hpp"

namespace farm {

/// Why the server has not done something with @p bucket, in one line.
[[nodiscard]] inline std::string storage_error(std::string_view bucket, natsStatus status) {
  if (status == NATS_NO_RESPONDERS) return fmt::format("{}: the server has no JetStream", bucket);
  return fmt::format("{}: {}", bucket, nats::text_of(status));
}

}  // namespace farm
