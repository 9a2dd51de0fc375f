#include "daemon/watch/unit_trace.hpp"

#include <algorithm>
#include <array>

#include "device/bus/unit_time.hpp"
#include "trace/arming.hpp"

namespace axisd {
namespace {

/// What a trace sees itself, on the grid of the cycles.
constexpr std::array kSeenByTheTrace{record::EventKind::DriveState, record::EventKind::Fault,
                                     record::EventKind::Alarm};

}  // namespace

tl::expected<void, trace::Problem> UnitTrace::start(const trace::Settings& settings) {
  if (auto started = tracer_.start(settings, device_.cycle()); !started) return started;
  listen(true);
  return {};
}

std::optional<trace::Problem> UnitTrace::problem_of(const trace::Settings& settings) const {
  const auto plan = trace::make_plan(std::as_const(device_).unit(), settings, device_.cycle());
  return plan ? std::nullopt : std::optional{plan.error()};
}

void UnitTrace::stop() noexcept {
  tracer_.stop();
  look_around();
}

/// Without room for another listener a trace has no frames or no events.
void UnitTrace::listen(bool wanted) noexcept {
  listens_ = wanted;
  if (wanted) {
    static_cast<void>(cycles_.add(tracer_));
    static_cast<void>(frames_.add(*this));
    static_cast<void>(events_.add(*this));
  } else {
    cycles_.remove(tracer_);
    events_.remove(*this);
    frames_.remove(*this);
  }
}

void UnitTrace::on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept {
  tracer_.on_frame(
      {.time = device::unit_time(time),
       .id = frame.id,
       .extended = frame.extended,
       .remote = frame.remote,
       .direction = direction == Direction::Sent ? trace::Direction::Sent : trace::Direction::Received,
       .length = frame.length,
       .data = frame.data});
}

void UnitTrace::on_event(const UnitEvent& event) noexcept {
  if (std::ranges::find(kSeenByTheTrace, event.kind) != kSeenByTheTrace.end()) return;
  const drive::DriveUnit& unit = std::as_const(device_).unit();
  const drive::DriveObject* const object = unit.object(event.object);
  tracer_.on_event({.time = device::unit_time(event.time),
                    .kind = record::row_of(event.kind).name,
                    .place = object != nullptr ? trace::place_of(unit, *object) : trace::kControlUnitPlace,
                    .active = event.active,
                    .number = event.number,
                    .index = event.index,
                    .value = event.value,
                    .text = event.text});
}

}  // namespace axisd
