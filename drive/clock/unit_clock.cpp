#include "drive/clock/unit_clock.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drive {
namespace {

constexpr double kMillisecondsPerSecond = 1000.0;

/// How far @p to is behind @p from, as far as r3108 can show it.
std::int32_t difference(UtcTime from, UtcTime to) noexcept {
  using Shown = std::numeric_limits<std::int32_t>;
  const std::int64_t exact = static_cast<std::int64_t>(to) - static_cast<std::int64_t>(from);
  return static_cast<std::int32_t>(
      std::clamp(exact, static_cast<std::int64_t>(Shown::min()), static_cast<std::int64_t>(Shown::max())));
}

}  // namespace

void UnitClock::continue_at(Uptime now) noexcept {
  const Uptime before = std::exchange(line_.now, now);
  if (line_.utc_ahead) *line_.utc_ahead += static_cast<std::int64_t>(before) - static_cast<std::int64_t>(now);
}

void UnitClock::run_utc(bool runs) noexcept {
  line_.utc_ahead = runs ? std::optional{-static_cast<std::int64_t>(line_.now)} : std::nullopt;
  synchronised_ = false;
  ping_.reset();
  last_deviation_ = last_violation_ = 0;
  violated_ = violated_by_ = 0;
  plan_question();
}

void UnitClock::choose(Method method) noexcept {
  method_ = method;
  ping_.reset();
  plan_question();
}

void UnitClock::plan_question() noexcept {
  host_due_ = is_utc() && method_ == Method::Host ? line_.now : kNever;
}

void UnitClock::ping() noexcept {
  if (is_utc() && method_ == Method::PingSnap) ping_ = line_.now;
}

UnitClock::Correction UnitClock::give(Part part, std::uint32_t value) noexcept {
  given_[part] = value;
  if (part != kMillisecondsOfTheDay || !is_utc()) return Correction::None;
  const UtcTime utc = given_[kDays] * kMillisecondsOfADay + value;
  if (method_ == Method::Simple) return set(utc);
  return method_ == Method::PingSnap ? snap(utc) : Correction::None;
}

/// It was @p utc when the ping came. A ping serves one snap, be it too late.
UnitClock::Correction UnitClock::snap(UtcTime utc) noexcept {
  const auto ping = std::exchange(ping_, std::nullopt);
  if (!ping || line_.now - *ping > kSnapTime) return Correction::None;
  return set(utc + (line_.now - *ping));
}

UnitClock::Correction UnitClock::answer(std::optional<UtcTime> host) noexcept {
  host_due_ = line_.now + kHostPeriod;
  return host ? set(*host) : Correction::None;
}

UnitClock::Correction UnitClock::set(UtcTime utc) noexcept {
  const UtcTime before = line_.utc().value_or(0);
  line_.utc_ahead = static_cast<std::int64_t>(utc) - static_cast<std::int64_t>(line_.now);
  if (!std::exchange(synchronised_, true)) return Correction::Within;
  last_deviation_ = difference(before, utc);
  const std::int64_t tolerance = std::llround(settings.tolerance * kMillisecondsPerSecond);
  if (std::abs(static_cast<std::int64_t>(last_deviation_)) <= tolerance) return Correction::Within;
  last_violation_ = last_deviation_;
  violated_ = before;
  violated_by_ = utc;
  return Correction::Beyond;
}

}  // namespace drive
