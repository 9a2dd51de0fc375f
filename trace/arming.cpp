#include "trace/arming.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "trace/trigger_table.hpp"

namespace trace {
namespace {

using Outcome = tl::expected<void, Problem>;

tl::unexpected<Problem> problem(Problem::Kind kind, std::string key, std::string expected) {
  return tl::unexpected{Problem{kind, std::move(key), std::move(expected)}};
}

tl::expected<Signal, Problem> signal_for(const drive::DriveUnit& unit, std::string_view name,
                                         const std::string& key) {
  return find_signal(unit, name).map_error([&](Problem found) {
    found.key = key;
    return found;
  });
}

Outcome find_signals(const drive::DriveUnit& unit, const Settings& settings, Plan& plan) {
  if (settings.signals.empty() || settings.signals.size() > kMostSignals)
    return problem(settings.signals.empty() ? Problem::Kind::Malformed : Problem::Kind::TooMuch, "signals",
                   fmt::format("1 to {} signals", kMostSignals));
  for (const std::string& name : settings.signals) {
    auto found = signal_for(unit, name, fmt::format("signals[{}]", plan.signals.size()));
    if (!found) return tl::unexpected{found.error()};
    plan.readers.push_back(found->reader);
    plan.signals.push_back(std::move(*found));
  }
  return {};
}

Outcome find_trigger_source(const drive::DriveUnit& unit, const TriggerSettings& trigger, Plan& plan) {
  const TriggerRow& row = row_of(trigger.kind);
  if ((row.arguments & kTakesSignal) != 0) {
    const auto found = signal_for(unit, trigger.signal, "trigger.signal");
    if (!found) return tl::unexpected{found.error()};
    plan.condition = found->reader;
  }
  if ((row.arguments & kTakesBand) != 0 && trigger.low > trigger.high)
    return problem(Problem::Kind::Malformed, "trigger.high", "a number that is not below `low`");
  if ((row.arguments & kTakesPlace) != 0 && trigger.place && object_at(unit, *trigger.place) == nullptr)
    return problem(Problem::Kind::NotFound, "trigger.axis", fmt::format("0 to {}", unit.axes().size()));
  return {};
}

constexpr std::size_t whole_parts(unit::Duration time, unit::Duration part) noexcept {
  return static_cast<std::size_t>((time + part - unit::Duration{1}) / part);
}

Outcome measure(const Settings& settings, unit::Duration cycle, Plan& plan) {
  if (settings.every < unit::Duration{0} || settings.every % kStep != unit::Duration{0})
    return problem(Problem::Kind::Malformed, "every", "a multiple of 0.000125 s, or \"cycle\"");
  const unit::Duration every = settings.every == kEveryCycle ? cycle : settings.every;
  plan.steps = static_cast<long>(settings.every / kStep);
  plan.recordings = settings.repeat ? settings.keep + 1 : 1;
  plan.size = {.signals = plan.signals.size(),
               .samples = settings.samples.value_or(whole_parts(settings.length, every)),
               .before = whole_parts(settings.before, every)};
  const std::size_t most = kMostValues / (plan.size.signals * plan.recordings);
  const char* const length = settings.samples ? "samples" : "length_s";
  if (plan.size.samples == 0) return problem(Problem::Kind::Malformed, length, "one sample at least");
  if (plan.size.samples > most)
    return problem(Problem::Kind::TooMuch, length,
                   fmt::format("at most {} samples ({:g} s) with these signals and results", most,
                               static_cast<double>(most) * std::chrono::duration<double>{every}.count()));
  if (plan.size.before > plan.size.samples)
    return problem(Problem::Kind::Malformed, "before_s", "a time that is not beyond the whole length");
  return {};
}

}  // namespace

tl::expected<Plan, Problem> make_plan(const drive::DriveUnit& unit, const Settings& settings,
                                      unit::Duration cycle) {
  Plan plan;
  if (auto found = find_signals(unit, settings, plan); !found) return tl::unexpected{found.error()};
  if (auto found = find_trigger_source(unit, settings.trigger, plan); !found) return tl::unexpected{found.error()};
  if (auto fits = measure(settings, cycle, plan); !fits) return tl::unexpected{fits.error()};
  return plan;
}

}  // namespace trace
