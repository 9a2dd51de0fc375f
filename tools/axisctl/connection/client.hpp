#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "os/descriptor.hpp"
#include "tools/axisctl/connection/failure.hpp"

namespace axisctl {

/// What is asked of a daemon.
struct Call {
  std::string_view method;
  nlohmann::json params = nlohmann::json::object();
};

/// A connection to a daemon, for any number of requests one after the other, and for what it tells unasked.
class Client {
 public:
  /// Connects to the daemon at socket @p path.
  [[nodiscard]] static Expected<Client> connect(const std::string& path);

  /// The result of @p call. Notices that come before it are left out.
  [[nodiscard]] Expected<nlohmann::json> ask(const Call& call);
  /// The next line that the daemon sends unasked; nothing once it has closed the connection.
  [[nodiscard]] Expected<std::optional<nlohmann::json>> next_notice();

 private:
  Client(std::string path, os::Descriptor socket) : path_{std::move(path)}, socket_{std::move(socket)} {}

  bool send_all(std::string_view rest);
  /// One line without its newline.
  Expected<std::string> read_line();
  void wait_at_most(std::chrono::seconds time);

  std::string path_;
  os::Descriptor socket_;
  std::string input_{};
  int last_id_ = 0;
};

/// Asks the daemon at socket @p path once.
[[nodiscard]] Expected<nlohmann::json> ask(const std::string& path, const Call& call);

}  // namespace axisctl
