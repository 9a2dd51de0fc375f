#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "os/descriptor.hpp"

namespace e2e {

/// A client of the control socket that can also misbehave.
class ControlClient {
 public:
  /// Connects to @p path; throws std::system_error.
  explicit ControlClient(const std::string& path);

  /// Sends @p bytes as they are.
  void send(std::string_view bytes);
  /// The next answer without its newline; throws std::runtime_error if none comes or the daemon hangs up.
  std::string line();
  /// Sends @p request as one line and returns the answer.
  nlohmann::json ask(const nlohmann::json& request);

 private:
  os::Descriptor socket_;
  std::string rest_;
};

}  // namespace e2e
