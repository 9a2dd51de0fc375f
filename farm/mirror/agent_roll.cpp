#include "farm/mirror/agent_roll.hpp"

#include <utility>

#include "farm/naming/subjects.hpp"
#include "os/clock.hpp"

namespace farm {
namespace {

constexpr std::chrono::milliseconds kLook{50};

}  // namespace

AgentRoll::AgentRoll(axisd::ServiceEvents& events, Messages& messages, std::string farm, const MirrorTimes& times)
    : messages_{messages}, farm_{std::move(farm)}, settling_{times.quiet, times.longest} {
  timer_ = events.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<AgentRoll*>(self)->look();
        return 0;
      },
      this);
  messages_.subscribe(all_agents_subject(farm_), [this](const Message& message) { take(message); });
}

AgentRoll::~AgentRoll() {
  messages_.unsubscribe(all_agents_subject(farm_));
}

void AgentRoll::call(OnAll on_all) {
  on_all_ = std::move(on_all);
  heard_.clear();
  settling_.begin(os::monotonic_time());
  messages_.publish(who_subject(farm_), "{}");
  axisd::ServiceEvents::start(timer_, kLook);
}

void AgentRoll::take(const Message& message) {
  auto beat = parse_agent_beat(message.subject, message.data);
  if (!beat) return;
  const std::string host = beat->host;
  const bool is_new = heard_.insert_or_assign(host, *std::move(beat)).second;
  if (is_new) settling_.take_new(os::monotonic_time());
}

void AgentRoll::look() {
  if (*settling_.due() > os::monotonic_time()) return axisd::ServiceEvents::start(timer_, kLook);
  std::vector<AgentBeat> all;
  for (auto& [host, beat] : std::exchange(heard_, {})) all.push_back(std::move(beat));
  std::exchange(on_all_, {})(std::move(all));
}

}  // namespace farm
