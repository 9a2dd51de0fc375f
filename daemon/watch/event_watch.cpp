#include "daemon/watch/event_watch.hpp"

#include <algorithm>
#include <utility>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/object_index.hpp"

namespace axisd {

using record::EventKind;

bool EventWatch::add(EventListener& listener) {
  if (past_ == nullptr) {
    past_ = std::make_unique<Past>(Past{.writes = WriteWatch{device_}, .messages = ActiveMessages{device_}});
    device_.unit().for_each_object([this](const drive::DriveObject& object) {
      past_->objects.push_back({object.number(), state_of(object.number())});
    });
    if (!tap_.add(*this)) {
      past_.reset();
      return false;
    }
  }
  return listeners_.add(listener);
}

void EventWatch::remove(EventListener& listener) noexcept {
  listeners_.remove(listener);
  if (is_watched() || past_ == nullptr) return;
  tap_.remove(*this);
  past_.reset();
}

void EventWatch::tell(UnitEvent event) noexcept {
  event.axis = axis_of(event.object);
  for (EventListener* const listener : listeners_.all()) listener->on_event(event);
}

bool EventWatch::is_other_command(std::string_view method, unsigned axis, std::string_view text) {
  if (!past_) return true;
  const auto is_it = [&](const Command& last) { return last.method == method && last.axis == axis; };
  const auto found = std::ranges::find_if(past_->commands, is_it);
  if (found != past_->commands.end()) return std::exchange(found->text, std::string{text}) != text;
  past_->commands.push_back({method, axis, std::string{text}});
  return true;
}

void EventWatch::on_nmt_state(canopen::NmtState from, canopen::NmtState to, canopen::TimePoint now) noexcept {
  tell({.time = now,
        .kind = EventKind::Nmt,
        .number = static_cast<std::uint16_t>(to),
        .text = name_of(to),
        .text_before = name_of(from)});
}

void EventWatch::on_bus_state(bus::ErrorState state, canopen::TimePoint now) noexcept {
  if (past_ == nullptr) return;
  const bus::ErrorState before = std::exchange(past_->bus, state);
  tell({.time = now,
        .kind = EventKind::Bus,
        .number = static_cast<std::uint16_t>(state),
        .text = name_of(state),
        .text_before = name_of(before)});
}

void EventWatch::on_parameter_written(const device::ParameterWindow::Target& at, double value,
                                      std::optional<double> before, canopen::TimePoint now) noexcept {
  tell({.time = now,
        .kind = EventKind::Parameter,
        .origin = record::Origin::Control,
        .object = at.object,
        .number = at.number,
        .index = static_cast<std::uint16_t>(at.index),
        .value = value,
        .before = before});
}

void EventWatch::on_object_written(std::uint16_t index, std::uint8_t sub_index, double value,
                                   std::optional<double> before, canopen::TimePoint now) noexcept {
  tell({.time = now,
        .kind = EventKind::Object,
        .origin = record::Origin::Control,
        .number = index,
        .index = sub_index,
        .value = value,
        .before = before});
}

void EventWatch::on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept {
  if (direction == Direction::Received) return past_->writes.on_received(frame);
  on_sent(frame, time);
}

void EventWatch::on_sent(const canopen::Frame& frame, canopen::TimePoint time) noexcept {
  if (auto written = past_->writes.on_sent(frame)) {
    written->time = time;
    return tell(*written);
  }
  const canopen::Identifier identifier = canopen::identifier_of(frame);
  const std::uint8_t node_id = device_.node_id();
  if (identifier == canopen::function_code::kErrorControl + node_id && !frame.remote && frame.length == 1 &&
      frame.data[0] == static_cast<std::uint8_t>(canopen::NmtState::Initialising))
    return tell({.time = time, .kind = EventKind::BootUp, .number = node_id});
  const auto emergency = device_.dictionary().stored(canopen::object::kCobIdEmcy, 0);
  if (!emergency || canopen::valid_identifier(static_cast<std::uint32_t>(*emergency)) != identifier) return;
  tell({.time = time,
        .kind = EventKind::Emergency,
        .number = canopen::load<std::uint16_t>(frame.data.data()),
        .data = frame.data});
}

void EventWatch::look(canopen::TimePoint now) noexcept {
  if (past_ == nullptr) return;
  look_at_messages(now);
  look_at_states(now);
}

std::uint8_t EventWatch::axis_of(std::uint8_t object) const noexcept {
  const std::uint8_t first = device_.unit().first_axis();
  return object < first ? std::uint8_t{0} : static_cast<std::uint8_t>(object - first + 1);
}

/// The control unit has none.
std::optional<drive::State> EventWatch::state_of(std::uint8_t object) const noexcept {
  const drive::DriveUnit& unit = device_.unit();
  if (const std::uint8_t axis = axis_of(object)) return device_.view(axis).state;
  if (unit.infeed() != nullptr && unit.infeed()->number() == object) return unit.infeed()->state();
  return std::nullopt;
}

void EventWatch::look_at_states(canopen::TimePoint now) noexcept {
  for (Seen& seen : past_->objects) {
    const auto state = state_of(seen.object);
    const auto before = std::exchange(seen.state, state);
    if (!state || !before || *state == *before) continue;
    tell({.time = now,
          .kind = EventKind::DriveState,
          .object = seen.object,
          .number = static_cast<std::uint16_t>(*state),
          .text = name_of(*state),
          .text_before = name_of(*before)});
  }
}

void EventWatch::look_at_messages(canopen::TimePoint now) noexcept {
  past_->messages.look([&](std::uint8_t object, const ActiveMessages::Message& message, bool active) {
    tell({.time = now,
          .kind = message.kind == drive::Kind::Fault ? EventKind::Fault : EventKind::Alarm,
          .object = object,
          .active = active,
          .number = message.row->number,
          .code = message.value,
          .text = message.row->name});
  });
}

}  // namespace axisd
