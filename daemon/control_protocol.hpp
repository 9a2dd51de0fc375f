#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>
#include <sys/un.h>
#include <tl/expected.hpp>

namespace control {

/// Longest line of either side (bytes, with the newline).
inline constexpr std::size_t kMaximumLine = 65536;

/// Interface a daemon uses unless told otherwise.
inline constexpr std::string_view kDefaultInterface = "vcan0";
/// Node-ID a daemon uses unless told otherwise.
inline constexpr int kDefaultNode = 2;

/// What a client can ask for.
enum class Method : std::uint8_t {
  Status,
  Explain,
  FaultInject,
  FaultAcknowledge,
  SetLoad,
  SetSupply,
  FailEncoder,
  SetInput,
  RestartBus,
  Quit
};

/// Name of a method on the socket.
struct MethodName {
  Method method;
  std::string_view name;
};

/// Every method, in the order of its enumeration.
inline constexpr std::array kMethods{
    MethodName{Method::Status, "status"},
    MethodName{Method::Explain, "explain"},
    MethodName{Method::FaultInject, "fault.inject"},
    MethodName{Method::FaultAcknowledge, "fault.ack"},
    MethodName{Method::SetLoad, "load.set"},
    MethodName{Method::SetSupply, "supply.set"},
    MethodName{Method::FailEncoder, "encoder.fail"},
    MethodName{Method::SetInput, "input.set"},
    MethodName{Method::RestartBus, "bus.restart"},
    MethodName{Method::Quit, "quit"},
};
static_assert(std::is_sorted(kMethods.begin(), kMethods.end(),
                             [](const MethodName& a, const MethodName& b) { return a.method < b.method; }),
              "name_of() indexes the table");

/// Name of @p method on the socket.
[[nodiscard]] constexpr std::string_view name_of(Method method) noexcept {
  return kMethods[static_cast<std::size_t>(method)].name;
}
/// The method called @p name, if there is one.
[[nodiscard]] std::optional<Method> method_named(std::string_view name) noexcept;

/// Folder of the control sockets: the first of $RUNTIME_DIRECTORY, $XDG_RUNTIME_DIR, /run for root, /tmp.
[[nodiscard]] std::string runtime_directory();
/// Path of the control socket of the daemon with address switch @p node (0..127: its node-ID, or 0) on the bus
/// whose bus::label() is @p label.
[[nodiscard]] std::string default_socket_path(std::string_view label, int node);
/// What the name of a control socket says of its daemon.
struct SocketName {
  std::string_view label;  ///< bus::label() of its bus
  int node = 0;            ///< its address switch, as in default_socket_path()
};
/// What @p file_name (without folder) says, if it is one that default_socket_path() gives.
[[nodiscard]] std::optional<SocketName> parse_socket_name(std::string_view file_name) noexcept;
/// Socket address of @p path, or in one line why it cannot be one (empty, or longer than 107 bytes).
[[nodiscard]] tl::expected<sockaddr_un, std::string> socket_address(std::string_view path);

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
[[nodiscard]] std::string request_line(int id, Method method, const nlohmann::json& params);
/// Line, newline included, that answers request @p id with @p result.
[[nodiscard]] std::string result_line(const nlohmann::json& id, const nlohmann::json& result);
/// Line, newline included, that refuses request @p id for the reason @p message.
[[nodiscard]] std::string error_line(const nlohmann::json& id, std::string_view message);
/// The result in the answer @p line to request @p id, or the message of its error.
[[nodiscard]] tl::expected<nlohmann::json, std::string> parse_answer(std::string_view line, int id);

}  // namespace control
