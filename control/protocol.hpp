#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

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
  std::string message;
};
/// Reads one request from @p line, or says in one line what is wrong with it. The id may be a number, a string or
/// null; nothing may be nested deeper than eight levels.
[[nodiscard]] tl::expected<Request, RequestError> parse_request(std::string_view line);
/// Line, newline included, that asks for @p method.
[[nodiscard]] std::string request_line(int id, std::string_view method, const nlohmann::json& params);
/// Line, newline included, that answers request @p id with @p result.
[[nodiscard]] std::string result_line(const nlohmann::json& id, const nlohmann::json& result);
/// Line, newline included, that refuses request @p id for the reason @p message.
[[nodiscard]] std::string error_line(const nlohmann::json& id, std::string_view message);
/// The result in the answer @p line to request @p id, or the message of its error.
[[nodiscard]] tl::expected<nlohmann::json, std::string> parse_answer(std::string_view line, int id);

}  // namespace control
