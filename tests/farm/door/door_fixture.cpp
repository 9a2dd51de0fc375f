#include "tests/farm/door/door_fixture.hpp"

#include "control/protocol.hpp"

namespace farm {
namespace {

using nlohmann::json;

/// What the daemon answers: its unit, a refusal of `explain`, and what it was asked for to all else.
std::string answer_of_daemon(const std::string& line) {
  const auto request = control::parse_request(line);
  if (!request) return "close";
  if (request->method == "units")
    return control::result_line(
        request->id,
        {{"units", {{{"unit", "vcan.0/5"}, {"on", true}, {"axes", 1}, {"profile", "s120"}, {"node_id", 5}}}}});
  if (request->method == "explain")
    return control::error_line(request->id, {control::ErrorCode::Refused, "not now"});
  return control::result_line(request->id, {{"method", request->method}, {"params", request->params}});
}

}  // namespace

void DoorTest::start(bool read_only) {
  door.reset();
  daemon = std::make_unique<gateway::FakeDaemon>(events, path, answer_of_daemon);
  daemons =
      std::make_unique<gateway::Daemons>(events, std::make_unique<gateway::SocketReach>(std::vector{path}), log);
  door =
      std::make_unique<Door>(Door::Parts{events, messages, *daemons, log}, Door::Settings{"lab", "a", read_only});
  door->on_up();
}

void DoorTest::open(bool read_only) {
  start(read_only);
  wait([this] { return is_served(); });
}

json DoorTest::answer_to_text(std::string_view data) {
  messages.published.clear();
  messages.come(kRequests, data, "mine");
  wait([this] { return !told("mine").empty(); });
  return told("mine").front();
}

std::vector<json> DoorTest::told(std::string_view subject) const {
  std::vector<json> found;
  for (const auto& each : messages.published)
    if (each.subject == subject) found.push_back(json::parse(each.data));
  return found;
}

}  // namespace farm
