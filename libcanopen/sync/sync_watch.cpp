#include "libcanopen/sync/sync_watch.hpp"

#include "libcanopen/base/object_index.hpp"

namespace canopen {
namespace {

constexpr std::size_t kTimer = 0;

/// How long a SYNC may take where the cycle has @p cycle us (1006h).
constexpr Duration patience(std::int64_t cycle) noexcept {
  return Duration{std::chrono::microseconds{cycle}} * 3 / 2;
}
static_assert(patience(1) == Duration{1500});

}  // namespace

SyncWatch::SyncWatch(Context& context) : Service{context, {.lives_in = kStatesOfPdo, .timers = 1}} {
  context_.dictionary.serve_writes(object::kCyclePeriod, 0, *this);
}

void SyncWatch::reload(Reload how) noexcept {
  if (how == Reload::Afresh) {
    stop();
    end_timeout();
  }
  const std::int64_t cycle = context_.dictionary.stored(object::kCyclePeriod, 0).value_or(0);
  if (patience(cycle) != patience_) set_period(cycle);
}

void SyncWatch::stop() noexcept {
  cancel(kTimer);
}

void SyncWatch::on_sync(std::uint8_t, Duration) noexcept {
  end_timeout();
  if (context_.state != NmtState::Operational || patience_ == Duration{0}) return;
  deadline_ = context_.now + patience_;
  if (!is_armed(kTimer)) arm(kTimer, deadline_);
}

void SyncWatch::on_timer(std::size_t) noexcept {
  if (context_.now < deadline_) return arm(kTimer, deadline_);
  timed_out_ = true;
  context_.errors.on_error(CommunicationError::SyncTimeout, 0);
}

Result<void> SyncWatch::write(const Entry&, std::int64_t value) {
  set_period(value);
  return {};
}

void SyncWatch::set_period(std::int64_t cycle) noexcept {
  patience_ = patience(cycle);
  if (patience_ == Duration{0}) {
    cancel(kTimer);
    end_timeout();
  } else if (is_armed(kTimer)) {
    deadline_ = context_.now + patience_;
    arm(kTimer, deadline_);
  }
}

void SyncWatch::end_timeout() noexcept {
  if (!timed_out_) return;
  timed_out_ = false;
  context_.errors.on_recovery(CommunicationError::SyncTimeout, 0);
}

}  // namespace canopen
