#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gateway/base/error.hpp"
#include "gateway/server/event_stream.hpp"

namespace gateway {

inline constexpr std::string_view kJson = "application/json";

/// A request as it has come.
struct Request {
  std::string verb{};
  std::string path{};                                          ///< percent-encoded, without the query
  std::vector<std::pair<std::string, std::string>> query{};    ///< percent-encoded
  std::vector<std::pair<std::string, std::string>> headers{};  ///< as often as they were sent
  std::string body{};

  /// The values of header @p name, which is in lower case.
  [[nodiscard]] std::vector<std::string> header(std::string_view name) const;
};

/// What is answered.
struct Response {
  Status status = Status::Ok;
  std::string body{};
  std::string content_type{kJson};
  std::vector<std::pair<std::string, std::string>> headers{};  ///< in place of those that every answer has
  std::shared_ptr<const std::string> shared_body{};            ///< in place of `body`, where many get the same

  [[nodiscard]] const std::string& text() const noexcept { return shared_body ? *shared_body : body; }
};
/// The answer that tells of @p error.
[[nodiscard]] Response response_of(const Error& error);

/// A request and its answer, which may be given at any time. Whoever holds it does not keep the client.
class Exchange {
 public:
  explicit Exchange(Request request) : request_{std::move(request)} {}

  [[nodiscard]] const Request& request() const noexcept { return request_; }
  /// Answers; what comes after the first answer is of no account.
  void answer(Response response);
  void answer(const Error& error) { answer(response_of(error)); }
  /// Answers by @p stream, which goes on until it ends or the client leaves: then @p on_gone is called.
  void stream(std::shared_ptr<EventStream> stream, std::function<void()> on_gone);
  /// Headers of any answer.
  void add_header(std::string name, std::string value) {
    headers_.emplace_back(std::move(name), std::move(value));
  }

 private:
  friend class HttpServer;

  Request request_;
  std::vector<std::pair<std::string, std::string>> headers_{};
  std::optional<Response> response_{};
  std::shared_ptr<EventStream> stream_{};
  std::function<void()> on_gone_{};
  std::function<void()> on_answer_{};  ///< of the server, while it waits
  bool is_over_ = false;
};

}  // namespace gateway
