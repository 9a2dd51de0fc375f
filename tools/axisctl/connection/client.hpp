#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
  /// Speaks to what is at the other end of @p socket, a stream; @p name is what messages call it.
  Client(std::string name, os::Descriptor socket) : name_{std::move(name)}, socket_{std::move(socket)} {}

  /// How messages call the daemon: the path of its socket.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// The result of @p call. Notices that come before it are left out.
  [[nodiscard]] Expected<nlohmann::json> ask(const Call& call);
  /// The results of @p calls, in their order, many asked at a time.
  [[nodiscard]] std::vector<Expected<nlohmann::json>> ask_all(std::span<const Call> calls);
  /// The next line that the daemon sends unasked; nothing once it has closed the connection.
  [[nodiscard]] Expected<std::optional<nlohmann::json>> next_notice();

 private:
  bool send_all(std::string_view rest);
  /// Asks; the number of the request.
  Expected<int> send(const Call& call);
  Expected<nlohmann::json> answer_to(int id);
  /// One line without its newline.
  Expected<std::string> read_line();

  std::string name_;
  os::Descriptor socket_;
  std::string input_{};
  int last_id_ = 0;
};

/// Asks the daemon at socket @p path once.
[[nodiscard]] Expected<nlohmann::json> ask(const std::string& path, const Call& call);

}  // namespace axisctl
