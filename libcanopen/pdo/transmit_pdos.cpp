#include "libcanopen/pdo/transmit_pdos.hpp"

#include "libcanopen/base/cob_id.hpp"

namespace canopen {
namespace {

/// Inhibit time in units of 100 us (CiA 301, 7.5.2.37).
constexpr Duration inhibit_time(std::int64_t value) noexcept {
  return std::chrono::microseconds{100 * value};
}
/// No inhibit time is longer.
constexpr Duration kLongestInhibit = inhibit_time(UINT16_MAX);
/// Event timer in ms (CiA 301, 7.5.2.37).
constexpr Duration event_time(std::int64_t value) noexcept {
  return std::chrono::milliseconds{value};
}

}  // namespace

TransmitPdos::TransmitPdos(Context& context, std::size_t first_timer)
    : context_{context},
      parameters_{context, Direction::Transmit},
      first_timer_{first_timer},
      states_(parameters_.pdos().size()) {
  parameters_.listen(*this);
  synchronous_.reserve(states_.size());
  event_driven_.reserve(states_.size());
  staged_.reserve(states_.size());
}

std::size_t TransmitPdos::timers_for(const Dictionary& dictionary) noexcept {
  std::size_t pdos = 0;
  for (std::uint16_t index = 0x1800; index < 0x1A00; ++index) pdos += dictionary.contains(index) ? 1U : 0U;
  return pdos * kTimersEach;
}

std::size_t TransmitPdos::timer(std::size_t position, Timer which) const noexcept {
  return first_timer_ + position * kTimersEach + static_cast<std::size_t>(which);
}

std::uint64_t TransmitPdos::pack(std::size_t position) const noexcept {
  return pdos()[position].plan.pack(context_.dictionary.image());
}

void TransmitPdos::load_times(std::size_t position) noexcept {
  const PdoSettings& pdo = pdos()[position];
  states_[position].inhibit = inhibit_time(parameters_.communication(pdo, pdo_sub::kInhibitTime));
  states_[position].event_period = event_time(parameters_.communication(pdo, pdo_sub::kEventTimer));
}

/// Sorts the valid PDOs into the lists that SYNC and changes of value walk.
void TransmitPdos::sort_out() noexcept {
  synchronous_.clear();
  event_driven_.clear();
  for (std::size_t position = 0; position < states_.size(); ++position) {
    const PdoSettings& pdo = pdos()[position];
    if (!pdo.is_active()) continue;
    (pdo.is_synchronous() ? synchronous_ : event_driven_).push_back(static_cast<std::uint16_t>(position));
  }
}

void TransmitPdos::reload() noexcept {
  stop();
  parameters_.reload();
  for (std::size_t position = 0; position < states_.size(); ++position) load_times(position);
  sort_out();
}

void TransmitPdos::start() noexcept {
  running_ = true;
  for (State& state : states_) {
    state.first = true;
    state.syncs = 0;
    state.sent = context_.now - kLongestInhibit;
  }
  for (const std::uint16_t position : event_driven_) transmit(position, pack(position));
}

void TransmitPdos::stop() noexcept {
  running_ = false;
  for (std::size_t i = 0; i < states_.size() * kTimersEach; ++i) context_.timers.cancel(first_timer_ + i);
}

/// Notes a SYNC for @p pdo and tells whether it has to be sent with it; @p payload holds its values.
bool TransmitPdos::is_due(const PdoSettings& pdo, State& state, std::uint64_t payload) noexcept {
  if (pdo.transmission_type == 0) return state.first || payload != state.payload;
  return ++state.syncs >= pdo.transmission_type;
}

void TransmitPdos::on_sync(std::uint8_t counter) noexcept {
  (void)counter;
  staged_.clear();
  for (const std::uint16_t position : synchronous_) {
    const PdoSettings& pdo = pdos()[position];
    const std::uint64_t payload = pdo.plan.pack(context_.dictionary.image());
    // Within the capacity reserved by the constructor.
    if (is_due(pdo, states_[position], payload)) staged_.push_back({position, payload});
  }
  for (const Staged& staged : staged_) transmit(staged.position, staged.payload);
}

void TransmitPdos::on_request(std::size_t position) noexcept {
  (void)position;
}

void TransmitPdos::on_values_changed() noexcept {
  if (!running_) return;
  for (const std::uint16_t position : event_driven_) {
    const std::uint64_t payload = pack(position);
    if (payload != states_[position].payload) request(position, payload);
  }
}

/// Sends now, or when the inhibit time is over.
void TransmitPdos::request(std::size_t position, std::uint64_t payload) noexcept {
  const State& state = states_[position];
  const TimePoint allowed = state.sent + state.inhibit;
  if (context_.now >= allowed) {
    transmit(position, payload);
  } else if (!context_.timers.is_armed(timer(position, Timer::Inhibit))) {
    context_.timers.arm(timer(position, Timer::Inhibit), allowed);
  }
}

void TransmitPdos::transmit(std::size_t position, std::uint64_t payload) noexcept {
  const PdoSettings& pdo = pdos()[position];
  State& state = states_[position];
  Frame frame = frame_under(pdo.identifier, pdo.plan.length());
  store(frame.data.data(), payload);
  context_.sink.send(frame, Delivery::Replaceable);
  state.payload = payload;
  state.sent = context_.now;
  state.syncs = 0;
  state.first = false;
  state.event_elapsed = false;
  if (pdo.is_synchronous()) return;
  if (state.inhibit.count() != 0) context_.timers.cancel(timer(position, Timer::Inhibit));
  if (state.event_period.count() != 0)
    context_.timers.arm(timer(position, Timer::Event), state.sent + state.event_period);
}

void TransmitPdos::on_timer(std::size_t which) noexcept {
  const std::size_t position = which / kTimersEach;
  State& state = states_[position];
  const std::uint64_t payload = pack(position);
  if (which % kTimersEach == static_cast<std::size_t>(Timer::Event)) {
    state.event_elapsed = true;
    request(position, payload);
  } else if (payload != state.payload || state.event_elapsed) {
    transmit(position, payload);
  }
}

void TransmitPdos::on_pdo_changed(std::size_t position) noexcept {
  for (const Timer which : {Timer::Event, Timer::Inhibit}) context_.timers.cancel(timer(position, which));
  load_times(position);
  sort_out();
  State& state = states_[position];
  state.first = true;
  state.syncs = 0;
  const PdoSettings& pdo = pdos()[position];
  state.event_elapsed = true;  // sends even if the values are those last sent
  if (running_ && pdo.is_active() && !pdo.is_synchronous()) request(position, pack(position));
}

void TransmitPdos::on_pdo_time_changed(std::size_t position, std::uint8_t sub_index, std::int64_t value) noexcept {
  State& state = states_[position];
  if (sub_index == pdo_sub::kInhibitTime) state.inhibit = inhibit_time(value);
  if (sub_index != pdo_sub::kEventTimer) return;
  state.event_period = event_time(value);
  const PdoSettings& pdo = pdos()[position];
  if (!running_ || !pdo.is_active() || pdo.is_synchronous()) return;
  if (value == 0) {
    context_.timers.cancel(timer(position, Timer::Event));
  } else {
    context_.timers.arm(timer(position, Timer::Event), context_.now + state.event_period);
  }
}

}  // namespace canopen
