#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

namespace axisd {

class Daemon;

/// Answers one request line of the control socket with one line (docs/control.md lists the methods).
std::string answer_request(Daemon& daemon, std::string_view line);

}  // namespace axisd
