#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "control/error.hpp"

namespace gateway {

/// Status codes of HTTP that are used (RFC 9110).
enum class Status : unsigned {
  Ok = 200,
  NoContent = 204,
  NotModified = 304,
  BadRequest = 400,
  Unauthorized = 401,
  Forbidden = 403,
  NotFound = 404,
  MethodNotAllowed = 405,
  RequestTimeout = 408,
  Conflict = 409,
  ContentTooLarge = 413,
  UnsupportedMediaType = 415,
  MisdirectedRequest = 421,
  UnprocessableContent = 422,
  TooManyRequests = 429,
  InternalServerError = 500,
  NotImplemented = 501,
  BadGateway = 502,
  ServiceUnavailable = 503,
  GatewayTimeout = 504,
};

/// The `code` of an error, and the status that goes with it.
struct ErrorRow {
  std::string_view code;
  Status status;
  std::string_view meaning;  ///< for docs/reference/http.md
};

/// What the gateway itself refuses.
enum class Refused : std::uint8_t {
  BadRequest,
  TokenMissing,
  TokenWrong,
  ReadOnly,
  ForbiddenOrigin,
  NoSuchPath,
  WrongVerb,
  TooLong,
  NotJson,
  WrongHost,
  TooMany,
  BrokenDaemon,
  NoDaemon,
  SilentDaemon,
};
/// In the order of the enumeration.
inline constexpr std::array kRefusals{
    ErrorRow{"bad-request", Status::BadRequest,
             "path, query or body is none, or names what the resource does not have"},
    ErrorRow{"token-missing", Status::Unauthorized, "a write without `Authorization: Bearer TOKEN`"},
    ErrorRow{"token-wrong", Status::Unauthorized, "a write with another token"},
    ErrorRow{"read-only-server", Status::Forbidden, "a write, and the server runs with `--read-only`"},
    ErrorRow{"forbidden-origin", Status::Forbidden, "the request comes from a web page of another origin"},
    ErrorRow{"no-such-path", Status::NotFound, "there is no such resource"},
    ErrorRow{"method-not-allowed", Status::MethodNotAllowed,
             "the resource has other methods, which `Allow` names"},
    ErrorRow{"too-long", Status::ContentTooLarge,
             "a body of more than 65536 bytes, or one that is too much for a line of the control socket"},
    ErrorRow{"not-json", Status::UnsupportedMediaType, "a body of another type than application/json"},
    ErrorRow{"wrong-host", Status::MisdirectedRequest, "`Host` is missing, twice, or no name of this server"},
    ErrorRow{"too-many", Status::TooManyRequests,
             "requests wait for the daemon, or streams are open, as many as may"},
    ErrorRow{"broken-daemon", Status::BadGateway,
             "the daemon has closed the connection, or has sent what is no answer"},
    ErrorRow{"no-daemon", Status::ServiceUnavailable, "the daemon cannot be reached at the moment"},
    ErrorRow{"silent-daemon", Status::GatewayTimeout, "the daemon has not answered within 10 s"},
};

/// The status of an error of the control socket.
struct ControlStatus {
  control::ErrorCode code;
  Status status;
};
/// In the order of control::kErrorNames.
inline constexpr std::array kControlStatus{
    ControlStatus{control::ErrorCode::Malformed, Status::BadRequest},
    ControlStatus{control::ErrorCode::UnknownMethod, Status::NotImplemented},
    ControlStatus{control::ErrorCode::UnknownUnit, Status::NotFound},
    ControlStatus{control::ErrorCode::BadParameter, Status::BadRequest},
    ControlStatus{control::ErrorCode::NotFound, Status::NotFound},
    ControlStatus{control::ErrorCode::OutOfRange, Status::UnprocessableContent},
    ControlStatus{control::ErrorCode::ReadOnly, Status::Conflict},
    ControlStatus{control::ErrorCode::Refused, Status::Conflict},
    ControlStatus{control::ErrorCode::Off, Status::Conflict},
    ControlStatus{control::ErrorCode::Busy, Status::ServiceUnavailable},
    ControlStatus{control::ErrorCode::Overflow, Status::ServiceUnavailable},
    ControlStatus{control::ErrorCode::Unreachable, Status::ServiceUnavailable},
};
static_assert(kControlStatus.size() == control::kErrorNames.size());

/// Why a request has no result.
struct Error {
  Status status = Status::InternalServerError;
  std::string code{};
  std::string message{};     ///< one line: what was wrong, and what was expected
  nlohmann::json details{};  ///< further members: `limits`, `abort_code`, ...; null: none
  std::string allow{};       ///< with Status::MethodNotAllowed: the methods that there are
};

/// What the gateway refuses for the reason in @p message.
[[nodiscard]] Error refuse(Refused why, std::string message);
/// What a daemon refuses. Without @p code its error is none that is known.
[[nodiscard]] Error refused_by_daemon(std::optional<control::ErrorCode> code, std::string message,
                                      nlohmann::json details);
/// The body of the answer: {"error": {"code": ..., "message": ...}}.
[[nodiscard]] std::string body_of(const Error& error);

}  // namespace gateway
