#pragma once

#include <chrono>
#include <string>

#include <tl/expected.hpp>

#include "os/descriptor.hpp"

namespace control {

/// Connects to the control socket @p path, if its server is one to be trusted. Whoever gives no @p patience gets a
/// socket that waits for nothing; otherwise it waits so long for each answer. An error is one line.
[[nodiscard]] tl::expected<os::Descriptor, std::string> connect_to(const std::string& path,
                                                                   std::chrono::seconds patience = {});

/// How long a @p socket waits for what it reads and writes (0: for ever).
void set_patience(const os::Descriptor& socket, std::chrono::seconds patience) noexcept;

}  // namespace control
