#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "control/protocol.hpp"

namespace axisctl {

/// What is asked of a daemon.
struct Call {
  std::string_view method;
  nlohmann::json params = nlohmann::json::object();
};

/// Asks the daemon at socket @p path; the result of its answer, or in one line why there is none.
[[nodiscard]] tl::expected<nlohmann::json, control::AnswerError> ask(const std::string& path, const Call& call);

}  // namespace axisctl
