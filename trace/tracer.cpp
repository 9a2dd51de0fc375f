#include "trace/tracer.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "trace/arming.hpp"
#include "trace/trigger_table.hpp"
#include "trace/unit_watch.hpp"

namespace trace {

/// All that a trace needs, which is there only when one was asked for.
struct Tracer::Armed {
  Armed(const drive::DriveUnit& unit, const Settings& wanted, Plan made)
      : settings{wanted}, plan{std::move(made)}, trigger{row_of(wanted.trigger.kind)}, watch{unit} {
    recordings.reserve(plan.recordings);
    for (std::size_t i = 0; i < plan.recordings; ++i) recordings.emplace_back(plan.size);
    current().begin(number);
  }

  /// Result @p number is written over when as many others are newer.
  Recording& at(std::uint64_t result) noexcept { return recordings[result % recordings.size()]; }
  Recording& current() noexcept { return at(number); }
  /// Whether the signal of the trigger has reached what is waited for.
  bool is_reached() noexcept {
    if (trigger.reached == nullptr) return false;
    const double now = plan.condition ? plan.condition->value() : 0.0;
    const double before = std::exchange(before_value, now).value_or(now);
    return trigger.reached(settings.trigger, before, now);
  }
  bool is_sample_due(bool at_cycle_end) noexcept {
    if (plan.steps == 0) return at_cycle_end;
    if (--steps_to_sample > 0) return false;
    steps_to_sample = plan.steps;
    return true;
  }

  Settings settings;
  Plan plan;
  const TriggerRow& trigger;
  UnitWatch watch;
  std::vector<Recording> recordings;
  std::uint64_t number = 1;  ///< of the result that is being recorded, or was last
  std::optional<double> before_value{};
  long steps_to_sample = plan.steps;
};

std::string_view name_of(Phase phase) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"off", "waiting", "recording", "done"};
  return kNames[static_cast<std::size_t>(phase)];
}

Tracer::Tracer(const drive::DriveUnit& unit) noexcept : unit_{unit} {}
Tracer::~Tracer() = default;

tl::expected<void, Problem> Tracer::start(const Settings& settings, unit::Duration cycle) {
  auto plan = make_plan(unit_, settings, cycle);
  if (!plan) return tl::unexpected{plan.error()};
  armed_.reset();
  armed_ = std::make_unique<Armed>(unit_, settings, std::move(*plan));
  phase_ = Phase::Waiting;
  return {};
}

void Tracer::stop() noexcept {
  if (!is_on()) return;
  armed_->current().end();
  phase_ = Phase::Done;
}

const Settings& Tracer::settings() const noexcept {
  return armed_->settings;
}

std::span<const Signal> Tracer::signals() const noexcept {
  return armed_ ? std::span<const Signal>{armed_->plan.signals} : std::span<const Signal>{};
}

const Recording* Tracer::current() const noexcept {
  return is_on() ? &armed_->current() : nullptr;
}

Tracer::Results Tracer::results() const noexcept {
  if (!armed_) return {};
  const std::uint64_t last = is_on() ? armed_->number - 1 : armed_->number;
  const std::uint64_t kept = is_on() ? armed_->recordings.size() - 1 : armed_->recordings.size();
  return {.first = last > kept ? last - kept + 1 : 1, .last = last};
}

const Recording* Tracer::result(std::uint64_t number) const noexcept {
  const Results there = results();
  return there.first <= number && number <= there.last ? &armed_->at(number) : nullptr;
}

void Tracer::on_cycle_begin(unit::TimePoint begin) noexcept {
  begin_ = begin;
  steps_ = 0;
  look(begin);  // what has come between two cycles acts from here on
}

void Tracer::on_step(long step) noexcept {
  steps_ = step;
  advance(begin_ + step * kStep, false);
}

void Tracer::on_cycle_end() noexcept {
  const unit::TimePoint now = begin_ + (steps_ + 1) * kStep;
  look(now);
  advance(now, true);
}

void Tracer::look(unit::TimePoint now) noexcept {
  if (is_on()) armed_->watch.look(now, [this](const Event& event) { on_event(event); });
}

void Tracer::advance(unit::TimePoint now, bool at_cycle_end) noexcept {
  if (!is_on()) return;
  Armed& armed = *armed_;
  if (armed.is_reached() && phase_ == Phase::Waiting) trigger(now);
  if (armed.is_sample_due(at_cycle_end)) armed.current().sample(now, armed.plan.readers);
  if (armed.current().is_full()) finish();
}

void Tracer::on_frame(const Frame& frame) noexcept {
  if (!is_on()) return;
  armed_->current().add(frame);
  const auto seen = armed_->trigger.seen;
  if (phase_ == Phase::Waiting && seen != nullptr && seen(armed_->settings.trigger, frame)) trigger(frame.time);
}

void Tracer::on_event(const Event& event) noexcept {
  if (!is_on()) return;
  armed_->current().add(event);
  const auto happened = armed_->trigger.happened;
  if (phase_ == Phase::Waiting && happened != nullptr && happened(armed_->settings.trigger, event))
    trigger(event.time);
}

void Tracer::trigger(unit::TimePoint time) noexcept {
  armed_->current().trigger(time);
  phase_ = Phase::Recording;
}

/// A trace that repeats goes on with the next result; frames and events before it belong to this one.
void Tracer::finish() noexcept {
  armed_->current().end();
  if (!armed_->settings.repeat) {
    phase_ = Phase::Done;
    return;
  }
  ++armed_->number;
  armed_->current().begin(armed_->number);
  phase_ = Phase::Waiting;
}

}  // namespace trace
