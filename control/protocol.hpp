#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "control/error.hpp"

namespace control {

/// Longest line of either side (bytes, with the newline).
inline constexpr std::size_t kMaximumLine = 65536;

/// A request as the server sees it.
struct Request {
  nlohmann::json id;  ///< handed back as it came; null where the request has none
  std::string method;
  nlohmann::json params = nlohmann::json::object();
};
/// Why a line is no request.
struct RequestError {
  nlohmann::json id;  ///< as far as the line has one
  Error error;
};
/// Reads one request from @p line, or says in one line what is wrong with it. The id may be a number, a string or
/// null; nothing may be nested deeper than eight levels.
[[nodiscard]] tl::expected<Request, RequestError> parse_request(std::string_view line);
/// Line, newline included, that asks for @p method.
[[nodiscard]] std::string request_line(int id, std::string_view method, const nlohmann::json& params);
/// Line, newline included, that answers request @p id with @p result.
[[nodiscard]] std::string result_line(const nlohmann::json& id, const nlohmann::json& result);
/// Line, newline included, that refuses request @p id with @p error.
[[nodiscard]] std::string error_line(const nlohmann::json& id, const Error& error);
/// Line, newline included, that nobody has asked for: @p value of what has been subscribed to under @p key.
[[nodiscard]] std::string notice_line(std::string_view key, const nlohmann::json& value);

/// Why a request has no result.
struct AnswerError {
  bool is_answer = false;           ///< the daemon refuses; else the line is no answer
  std::optional<ErrorCode> code{};  ///< of the daemon's error, if it is one that is known
  std::string message{};
  nlohmann::json details = nlohmann::json::object();  ///< further members of the error
};
/// The result in the answer @p line to request @p id, or its error.
[[nodiscard]] tl::expected<nlohmann::json, AnswerError> parse_answer(std::string_view line, int id);
/// A line as JSON; discarded if it is none, or nested deeper than eight levels.
[[nodiscard]] nlohmann::json parse_line(std::string_view line);

}  // namespace control
