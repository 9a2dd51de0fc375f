#include "gateway/base/error.hpp"

#include <utility>

#include "gateway/base/json_text.hpp"

namespace gateway {

using nlohmann::json;

Error refuse(Refused why, std::string message) {
  const ErrorRow& row = kRefusals[static_cast<std::size_t>(why)];
  return {.status = row.status, .code = std::string{row.code}, .message = std::move(message)};
}

Error refused_by_daemon(std::optional<control::ErrorCode> code, std::string message, json details) {
  if (!code) return refuse(Refused::BrokenDaemon, std::move(message));
  return {.status = kControlStatus[static_cast<std::size_t>(*code)].status,
          .code = std::string{control::name_of(*code)},
          .message = std::move(message),
          .details = std::move(details)};
}

std::string body_of(const Error& error) {
  json object = error.details.is_object() ? error.details : json::object();
  object["code"] = error.code;
  object["message"] = error.message;
  return json_text(json{{"error", std::move(object)}}) + '\n';
}

}  // namespace gateway
