#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "daemon/instance/instance.hpp"

namespace axisd {

/// What a control method acts on.
struct ProgramCall {
  Instance& instance;
  std::function<void()> power_off;  ///< of the whole program
};

/// Answers one request line of the control socket with one line (docs/control.md lists the methods).
std::string answer_request(const ProgramCall& call, std::string_view line);

}  // namespace axisd
