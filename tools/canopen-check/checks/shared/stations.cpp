#include "tools/canopen-check/checks/shared/stations.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace conformance {
namespace {

constexpr std::uint32_t kErrorControl = 0x700, kRequests = 0x600, kResponses = 0x580;
constexpr std::uint8_t kHighestNodeId = 127, kNodeIdBits = 0x7F;
/// Of the node-IDs among which a free one is looked for.
constexpr std::uint8_t kLowestCandidate = 112;
constexpr canopen::Duration kListen = std::chrono::milliseconds{50};

/// Asks @p node_id for its state and its device type: whatever state it is in, it answers one of them.
void ask(Context& context, std::uint8_t node_id) {
  Session& session = context.session();
  if (session.carries_remote_frames()) session.send({.id = kErrorControl + node_id, .length = 1, .remote = true});
  session.send({.id = kRequests + node_id, .length = 8, .data = {0x40, 0x00, 0x10}});
}

bool is_answer(const canopen::Frame& frame) noexcept {
  const std::uint32_t function = frame.id & ~std::uint32_t{kNodeIdBits};
  return !frame.remote && !frame.extended && (function == kErrorControl || function == kResponses) &&
         (frame.id & kNodeIdBits) != 0;
}

}  // namespace

std::vector<std::uint8_t> other_stations(Context& context) {
  Session& session = context.session();
  const auto foreign = [own = session.node_id()](const canopen::Frame& frame) {
    return is_answer(frame) && (frame.id & kNodeIdBits) != own;
  };
  std::set<std::uint8_t> found;
  const auto listen = [&](canopen::Duration span) {
    for (const TimedFrame& each : session.collect(foreign, span))
      found.insert(static_cast<std::uint8_t>(each.frame.id & kNodeIdBits));
  };
  for (std::uint8_t id = 1; id <= kHighestNodeId; ++id) {
    if (id == session.node_id()) continue;
    ask(context, id);
    listen(canopen::Duration::zero());
  }
  listen(kListen);
  return {found.begin(), found.end()};
}

bool alone(Context& context, const char* command) {
  const std::vector<std::uint8_t> others = other_stations(context);
  if (others.empty()) return true;
  context.skip(fmt::format("{} would concern other stations too: node {}", command, fmt::join(others, ", ")));
  return false;
}

std::optional<std::uint8_t> unused_node_id(Context& context) {
  std::optional<std::uint8_t>& found = context.manners().free_node_id;
  if (found) return found;
  Session& session = context.session();
  for (std::uint8_t id = kHighestNodeId; id >= kLowestCandidate; --id) {
    if (id == session.node_id()) continue;
    session.drain();
    ask(context, id);
    const auto answer = session.wait_for(
        [id](const canopen::Frame& frame) { return is_answer(frame) && (frame.id & kNodeIdBits) == id; }, kListen);
    if (!answer && !session.ended()) return found = id;
  }
  return std::nullopt;
}

}  // namespace conformance
