#pragma once

#include <string>

#include <tl/expected.hpp>

#include "farm/agent/process/program_start.hpp"

namespace farm::agent {

/// Which process serves the control socket at @p path, as the kernel knows it; the error is one line. It is one
/// that may be trusted.
[[nodiscard]] tl::expected<ProcessHandle, std::string> server_of_socket(const std::string& path);
/// The same of the hub of the bus at @p path.
[[nodiscard]] tl::expected<ProcessHandle, std::string> server_of_bus(const std::string& path);

}  // namespace farm::agent
