#include "can/bus_faults/bus_faults.hpp"

#include <cerrno>
#include <cstring>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <sys/socket.h>

#include "can/userbus/join.hpp"
#include "can/userbus/request.hpp"
#include "os/descriptor.hpp"

namespace bus_faults {

namespace {

using nlohmann::json;
using userbus::JoinError;

using Result = tl::expected<json, Refusal>;

tl::unexpected<Refusal> failed(std::string text) {
  return tl::unexpected{Refusal{.by_hub = false, .text = std::move(text)}};
}

/// What the hub has told as text @p told with errno @p error.
Result read(const userbus::Path& path, int error, std::string_view told) {
  json result = json::parse(told, nullptr, false);
  if (error == 0 && result.is_object()) return result;
  if (error == EINVAL && result.is_object() && result.contains("message"))
    return tl::unexpected{Refusal{.by_hub = true, .text = result["message"].get<std::string>()}};
  if (error == EINVAL)
    return failed(fmt::format("{}: its hub is of an older version, which has no faults", path.text));
  return failed(
      fmt::format("{}: the hub has not answered: {}", path.text, std::strerror(error != 0 ? error : EPROTO)));
}

/// One member, and what it asks.
class Asker {
 public:
  explicit Asker(const userbus::Path& path)
      : path_{path},
        joined_{userbus::join(path, nullptr, userbus::Kind::Port, SOCK_CLOEXEC)},
        socket_{joined_.descriptor} {}

  Result ask(const char* method, json params) {
    if (!socket_) {
      const bool nobody = joined_.error == JoinError::NotServed || joined_.error == JoinError::None;
      return failed(fmt::format("{}: {}", path_.text, nobody ? "is not served" : userbus::text_of(joined_.error)));
    }
    const std::string request = json{{"method", method}, {"params", std::move(params)}}.dump(
        -1, ' ', false, json::error_handler_t::replace);
    std::vector<char> reply(userbus::kLongestMessage);
    if (request.size() > userbus::kLongestMessage - sizeof(userbus::Request))
      return failed(fmt::format("a fault of {} bytes is too long", request.size()));
    const userbus::Answer answer = userbus::ask(socket_.get(), userbus::Operation::Inject, 0, request.data(),
                                                request.size(), reply.data(), reply.size());
    return read(path_, answer.error, {reply.data(), answer.size});
  }

  /// All of a list that comes in several messages.
  Result ask_for_all(const char* method, const char* name) {
    json all = json::array();
    for (;;) {
      auto part = ask(method, {{"behind", all.size()}});
      if (!part) return part;
      const json& rows = part->at(name);
      all.insert(all.end(), rows.begin(), rows.end());
      if (rows.empty() || all.size() >= part->at("rows").get<std::size_t>()) return all;
    }
  }

 private:
  const userbus::Path& path_;
  userbus::Joined joined_;
  os::Descriptor socket_;
};

}  // namespace

tl::expected<std::uint32_t, Refusal> inject(const userbus::Path& path, const json& fault) {
  const auto result = Asker{path}.ask("inject.add", {{"fault", fault}});
  if (!result) return tl::unexpected{result.error()};
  return result->at("id").get<std::uint32_t>();
}

tl::expected<json, Refusal> list(const userbus::Path& path) {
  return Asker{path}.ask_for_all("inject.list", "faults");
}

tl::expected<json, Refusal> kinds(const userbus::Path& path) {
  return Asker{path}.ask_for_all("inject.kinds", "kinds");
}

tl::expected<std::size_t, Refusal> take_back(const userbus::Path& path, std::optional<std::uint32_t> number) {
  const auto result = Asker{path}.ask("inject.remove", number ? json{{"id", *number}} : json::object());
  if (!result) return tl::unexpected{result.error()};
  return result->at("removed").get<std::size_t>();
}

}  // namespace bus_faults
