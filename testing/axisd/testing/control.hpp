#pragma once

#include <nlohmann/json.hpp>

#include "axisd/testing/process.hpp"

namespace axisd::testing {

/// The unit has refused a request, for the reason in what().
struct Refused : Error {
  Refused(const std::string& message, std::string error_code) : Error{message}, code{std::move(error_code)} {}
  std::string code;  ///< as in docs/reference/control.md: out-of-range
};

/// A connection to the control socket of a unit (docs/reference/control.md).
class Control {
 public:
  /// Connects to @p path; Error.
  explicit Control(const std::string& path) : socket_{::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0), "socket"} {
    const sockaddr_un address = address_of(path);
    if (::connect(socket_.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      throw Error{path + ": " + std::strerror(errno)};
  }

  /// The result of a method; Refused, Error if the daemon has ended, Timeout after ten seconds.
  nlohmann::json call(const std::string& method, const nlohmann::json& params) {
    const int number = ++number_;
    const std::string line = nlohmann::json{{"id", number}, {"method", method}, {"params", params}}.dump() + '\n';
    if (::send(socket_.number(), line.data(), line.size(), MSG_NOSIGNAL) < 0) throw Error{"axisd has ended"};
    constexpr Milliseconds kPatience{10000};
    Deadline deadline{kPatience};
    while (true) {
      nlohmann::json answer = read_line(deadline, method);
      if (answer.value("id", 0) != number) continue;
      if (answer.contains("error"))
        throw Refused{method + ": " + answer["error"].value("message", ""), answer["error"].value("code", "")};
      return answer["result"];
    }
  }

  /// The next line, of a subscription too; Timeout with @p what.
  nlohmann::json read_line(Deadline& deadline, const std::string& what) {
    std::size_t length = 0;
    while ((length = rest_.find('\n')) == std::string::npos) {
      if (!deadline.await(socket_.number())) throw Timeout{what + " has not come in time"};
      std::array<char, 4096> part{};
      const ssize_t size = ::recv(socket_.number(), part.data(), part.size(), 0);
      if (size <= 0) throw Error{"axisd has ended"};
      rest_.append(part.data(), static_cast<std::size_t>(size));
    }
    nlohmann::json line = nlohmann::json::parse(rest_.substr(0, length));
    rest_.erase(0, length + 1);
    return line;
  }

 private:
  Descriptor socket_;
  std::string rest_;
  int number_ = 0;
};

}  // namespace axisd::testing
