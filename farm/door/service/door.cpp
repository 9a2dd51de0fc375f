#include "farm/door/service/door.hpp"

#include <algorithm>
#include <chrono>
#include <random>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "farm/documents/numbers.hpp"
#include "farm/naming/subjects.hpp"
#include "gateway/units/unit_list.hpp"
#include "os/clock.hpp"
#include "version/version.hpp"

namespace farm {

namespace {

using nlohmann::json;

constexpr std::chrono::microseconds kStep =
    std::chrono::microseconds{std::chrono::seconds{1}} / StatusRound::kSteps;
/// Who is there is told every 250 ms.
constexpr std::size_t kStepsOfBeat = StatusRound::kSteps / 4;
/// Before a door opens it listens for so long whether another one has the name: four of its beats.
constexpr std::size_t kStepsToListen = StatusRound::kSteps;
/// And until it knows the units: one that opens without them says that they are gone. A daemon that stands still
/// keeps the others waiting for no longer than this.
constexpr std::size_t kStepsToKnow = 5 * StatusRound::kSteps;
/// Units that are told in one message.
constexpr std::size_t kUnitsOfPart = 400;

std::uint64_t new_instance() {
  std::random_device device;
  return std::uniform_int_distribution<std::uint64_t>{1, kGreatestNumber}(device);
}

std::string present() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::now()));
}

}  // namespace

Door::Door(const Parts& parts, Settings settings)
    : parts_{parts},
      settings_{std::move(settings)},
      instance_{new_instance()},
      service_{settings_.farm, settings_.host, fmt::format("{:016X}", instance_), std::string{version::number()},
               present()},
      claim_{instance_},
      outlets_{parts_.daemons, parts_.messages},
      rpc_{{parts_.messages, parts_.daemons, roster_, outlets_}, settings_.host, settings_.read_only},
      statuses_{settings_.farm, settings_.host, parts_.messages, parts_.daemons, roster_},
      timer_{parts_.events.timer(
          [](sd_event_source*, std::uint64_t, void* self) noexcept {
            static_cast<Door*>(self)->step();
            return 0;
          },
          this)} {
  parts_.daemons.listen(this);
  parts_.daemons.want_events(true);
  parts_.messages.subscribe(door_subject(settings_.farm, settings_.host),
                            [this](const Message& message) { hear_door(message); });
  on_units();
  step();
}

Door::~Door() {
  parts_.daemons.listen(nullptr);
}

void Door::on_up() {
  steps_up_ = 0;
  beat();
}

void Door::on_event(const json& event) {
  const json name = event.value("unit", json{});
  const UnitName* const unit =
      name.is_string() ? roster_.name_in_farm(name.get_ref<const std::string&>()) : nullptr;
  if (!claim_.has() || unit == nullptr) return;
  json told = event;
  told["unit"] = unit->text();
  parts_.messages.publish(event_subject(settings_.farm, *unit),
                          told.dump(-1, ' ', false, json::error_handler_t::replace));
  if (event.value("kind", json{}) == "power") ask_for_units();
}

/// Daemons have come or gone.
void Door::on_units() {
  std::set<std::string> paths;
  for (const gateway::DaemonClient* const daemon : parts_.daemons.clients()) paths.insert(daemon->path());
  if (roster_.keep(paths)) follow_units();
  for (gateway::DaemonClient* const daemon : parts_.daemons.clients())
    if (!roster_.knows(daemon->path())) ask_for_units(*daemon);
}

void Door::ask_for_units() {
  for (gateway::DaemonClient* const daemon : parts_.daemons.clients()) ask_for_units(*daemon);
}

void Door::ask_for_units(gateway::DaemonClient& daemon) {
  if (!asked_.insert(daemon.path()).second) return;
  gateway::ask_for_units(
      daemon, [this, path = daemon.path(), alive = std::weak_ptr{alive_}](const gateway::Answer& answer) {
        if (!alive.expired()) take_units(path, answer);
      });
}

void Door::take_units(const std::string& path, const gateway::Answer& answer) {
  asked_.erase(path);
  if (answer && roster_.take(path, *answer)) follow_units();
}

/// Requests come for the units that are there; whoever has asked for another one is told that nobody is.
void Door::follow_units() {
  if (!claim_.has()) return;
  for (auto unit = served_.begin(); unit != served_.end();) {
    const bool is_there = roster_.find(*unit) != nullptr;
    if (!is_there) parts_.messages.drain(rpc_subject(settings_.farm, *unit));
    unit = is_there ? std::next(unit) : served_.erase(unit);
  }
  for (const auto& [name, reached] : roster_.units())
    if (served_.insert(name).second)
      parts_.messages.subscribe(rpc_subject(settings_.farm, name),
                                [this, unit = name](const Message& message) { rpc_.take(unit, message); });
  beat_soon();
}

void Door::hear_door(const Message& message) {
  const auto beat = parse_door_beat(message.subject, message.data);
  if (!beat) return parts_.log.warning("{}", beat.error());
  claim_.hear(beat->instance, os::monotonic_time());
  look_at_claim();
}

void Door::look_at_claim() {
  const bool is_free = claim_.is_free(os::monotonic_time());
  if (!is_free && !std::exchange(is_told_taken_, true))
    parts_.log.warning("another door on the farm {} is called {}, too: this one opens when that is gone",
                       settings_.farm, settings_.host);
  if (claim_.has() && !is_free) return close();
  if (!claim_.has() && is_free && is_ready()) open();
}

bool Door::is_ready() const {
  const auto is_known = [this](const gateway::DaemonClient* daemon) { return roster_.knows(daemon->path()); };
  if (!parts_.messages.is_up() || steps_up_ < kStepsToListen) return false;
  return steps_up_ >= kStepsToKnow || std::ranges::all_of(parts_.daemons.clients(), is_known);
}

void Door::open() {
  claim_.take();
  is_told_taken_ = false;
  parts_.messages.subscribe(who_subject(settings_.farm), [this](const Message&) { beat_soon(); });
  for (const ServiceQuestion question : kServiceQuestions)
    for (const std::string& subject : service_subjects(question, service_.id))
      parts_.messages.subscribe(subject, [this, question](const Message& message) {
        if (message.reply.empty()) return;
        parts_.messages.publish(message.reply, service_answer(question, service_, roster_, rpc_.counts()));
      });
  parts_.log.info("open: {} on the farm {}", settings_.host, settings_.farm);
  follow_units();
}

void Door::close() {
  claim_.give_up();
  parts_.messages.unsubscribe(who_subject(settings_.farm));
  for (const ServiceQuestion question : kServiceQuestions)
    for (const std::string& subject : service_subjects(question, service_.id))
      parts_.messages.unsubscribe(subject);
  for (const UnitName& unit : std::exchange(served_, {})) parts_.messages.drain(rpc_subject(settings_.farm, unit));
  outlets_.end_all();
}

void Door::step() {
  axisd::ServiceEvents::start(timer_, kStep);
  ++steps_;
  if (parts_.messages.is_up()) ++steps_up_;
  look_at_claim();
  if (claim_.has() && parts_.messages.is_up()) statuses_.step();
  if (std::exchange(wanted_, Wanted::Never) == Wanted::Again || steps_ % kStepsOfBeat == 0) beat();
  if (steps_ % StatusRound::kSteps != 0) return;
  ask_for_units();
  outlets_.sweep();
}

/// At once, but no more often than every step: neither who asks without end nor hundreds of daemons that come
/// together bring a flood of lists.
void Door::beat_soon() {
  if (wanted_ == Wanted::Never) beat();
  wanted_ = wanted_ == Wanted::Never ? Wanted::Once : Wanted::Again;
}

void Door::beat() {
  if (!claim_.has()) return;
  DoorBeat beat{settings_.host, instance_, std::string{version::number()}, {}, 1, 1};
  const std::size_t count = roster_.units().size();
  beat.parts = count == 0 ? 1 : static_cast<std::uint32_t>((count + kUnitsOfPart - 1) / kUnitsOfPart);
  const std::string subject = door_subject(settings_.farm, settings_.host);
  auto unit = roster_.units().begin();
  for (beat.part = 1; beat.part <= beat.parts; ++beat.part) {
    beat.units.clear();
    for (; unit != roster_.units().end() && beat.units.size() < kUnitsOfPart; ++unit)
      beat.units.push_back(unit->second.unit);
    parts_.messages.publish(subject, text_of(beat));
  }
}

}  // namespace farm
