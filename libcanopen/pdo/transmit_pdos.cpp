#include "libcanopen/pdo/transmit_pdos.hpp"

#include <algorithm>

#include "libcanopen/base/cob_id.hpp"

namespace canopen {
namespace {

/// Event timer in ms (CiA 301, 7.5.2.37).
constexpr Duration event_time(std::int64_t value) noexcept {
  return std::chrono::milliseconds{value};
}

}  // namespace

TransmitPdos::TransmitPdos(Context& context)
    : Service{context,
              {.lives_in = kStatesOfPdo,
               .identifiers = PdoParameters::count_in(context.dictionary, Direction::Transmit),
               .timers = PdoParameters::count_in(context.dictionary, Direction::Transmit) * kTimersEach,
               .stage = ReloadStage::Senders}},
      image_{context.dictionary.image()},
      parameters_{context, Direction::Transmit},
      outgoing_(parameters_.pdos().size()),
      staged_(outgoing_.size()) {
  parameters_.listen(*this);
  synchronous_.reserve(outgoing_.size());
  event_driven_.reserve(outgoing_.size());
}

void TransmitPdos::list_identifiers(IdentifierList& list) const noexcept {
  for (std::size_t position = 0; position < pdos().size(); ++position) {
    const PdoSettings& pdo = pdos()[position];
    list.sends(pdo.identifier);
    if (pdo.is_requestable()) list.answers(pdo.identifier, position);
  }
}

TransmitPdos::Trigger TransmitPdos::trigger_of(const PdoSettings& pdo) noexcept {
  if (!pdo.is_active()) return Trigger::None;
  return std::ranges::lower_bound(kTriggers, pdo.transmission_type, {}, &TypeRow::last)->trigger;
}

void TransmitPdos::load_settings(std::size_t position) noexcept {
  const PdoSettings& settings = pdos()[position];
  Outgoing& pdo = outgoing_[position];
  pdo.frame = frame_under(settings.identifier, settings.plan.length());
  pdo.plan = settings.plan;
  pdo.trigger = trigger_of(settings);
  pdo.period = pdo.trigger == Trigger::Cyclic ? settings.transmission_type : std::uint8_t{1};
  pdo.inhibit = cycle_.whole(inhibit_time(parameters_.communication(settings, pdo_sub::kInhibitTime)));
  pdo.event_period = cycle_.whole(event_time(parameters_.communication(settings, pdo_sub::kEventTimer)));
  pdo.first_sync = static_cast<std::uint8_t>(parameters_.communication(settings, pdo_sub::kSyncStart));
  begin_anew(pdo);
}

/// The inhibit time of a TPDO that was synchronous runs from the last SYNC.
void TransmitPdos::note_last_sync(Outgoing& pdo) const noexcept {
  if (pdo.trigger == Trigger::Cyclic || pdo.trigger == Trigger::Acyclic) pdo.sent = last_sync_;
}

void TransmitPdos::begin_anew(Outgoing& pdo) noexcept {
  pdo.left = pdo.period;
  pdo.waits = pdo.first_sync != 0;
  pdo.fresh = true;
  pdo.is_due = false;
  any_waits_ |= pdo.waits;
}

/// Sorts the PDOs into the lists that SYNC and changes of value walk.
void TransmitPdos::sort_out() noexcept {
  synchronous_.clear();
  event_driven_.clear();
  for (std::size_t position = 0; position < outgoing_.size(); ++position) {
    const Trigger trigger = outgoing_[position].trigger;
    if (trigger == Trigger::None) continue;
    (trigger == Trigger::Event ? event_driven_ : synchronous_).push_back(static_cast<std::uint16_t>(position));
  }
}

void TransmitPdos::reload(Reload how) noexcept {
  stop();
  for (Outgoing& pdo : outgoing_) note_last_sync(pdo);
  parameters_.reload();
  for (Outgoing& pdo : outgoing_)
    if (how == Reload::Afresh) pdo.sent = TimePoint::min();
}

void TransmitPdos::claim_identifiers() noexcept {
  parameters_.claim_identifiers();
  for (std::size_t position = 0; position < outgoing_.size(); ++position) load_settings(position);
  sort_out();
}

void TransmitPdos::start() noexcept {
  running_ = true;
  last_sync_ = TimePoint::min();
  begin_moment();
  for (Outgoing& pdo : outgoing_) begin_anew(pdo);
  for (const std::uint16_t position : event_driven_) {
    outgoing_[position].is_due = true;
    if (cycle_.is_on()) {
      arm(timer(position, Timer::Event), cycle_.next_from(context_.now));
    } else {
      request(position, pack(outgoing_[position]));
    }
  }
}

void TransmitPdos::stop() noexcept {
  running_ = false;
  for (std::size_t i = 0; i < outgoing_.size() * kTimersEach; ++i) cancel(i);
}

void TransmitPdos::on_sync(std::uint8_t counter, Duration) noexcept {
  if (!running_) return;
  if (any_waits_) begin_cycles(counter);
  last_sync_ = context_.now;
  Outgoing* const all = outgoing_.data();
  const std::byte* const image = image_;
  const Frame** staged = staged_.data();
  for (const std::uint16_t position : synchronous_) {
    Outgoing& pdo = all[position];
    if (--pdo.left != 0) continue;
    pdo.left = pdo.period;
    const std::uint64_t payload = pdo.plan.pack(image);
    if (pdo.trigger != Trigger::Cyclic && !takes(pdo, payload)) continue;
    pdo.set_payload(payload);
    *staged++ = &pdo.frame;
  }
  for (const Frame** frame = staged_.data(); frame != staged; ++frame)
    context_.sink->send(**frame, Delivery::Replaceable);
}

/// A SYNC finds @p payload in a TPDO that does not go with every cycle; tells whether it is to be sent.
bool TransmitPdos::takes(Outgoing& pdo, std::uint64_t payload) noexcept {
  const bool changed = pdo.fresh || payload != pdo.payload();
  pdo.fresh = false;
  pdo.set_payload(payload);
  return changed && pdo.trigger == Trigger::Acyclic;
}

/// The SYNC with the counter of sub-index 6 is the first of its TPDO; those before do not count (CiA 301,
/// 7.5.2.37). Without a counter the first is any.
void TransmitPdos::begin_cycles(std::uint8_t counter) noexcept {
  any_waits_ = false;
  for (const std::uint16_t position : synchronous_) {
    Outgoing& pdo = outgoing_[position];
    if (!pdo.waits) continue;
    pdo.waits = counter != 0 && counter != pdo.first_sync;
    any_waits_ |= pdo.waits;
    if (pdo.waits) ++pdo.left;
  }
}

void TransmitPdos::on_request(std::size_t position) noexcept {
  Outgoing& pdo = outgoing_[position];
  if (pdo.trigger == Trigger::Event) {
    begin_moment();
    pdo.is_due = true;
    return request(position, pack(pdo));
  }
  const bool has_sample = pdo.trigger == Trigger::Sampled && !pdo.fresh;
  if (!has_sample) pdo.set_payload(pack(pdo));
  context_.sink->send(pdo.frame, Delivery::Replaceable);
}

void TransmitPdos::on_values_changed() noexcept {
  if (!running_) return;
  begin_moment();
  for (const std::uint16_t position : event_driven_) {
    const Outgoing& pdo = outgoing_[position];
    const std::uint64_t payload = pack(pdo);
    if (payload != pdo.payload()) request(position, payload);
  }
}

/// Sends now, or when the inhibit time is over: a time on the grid, unless a SYNC has begun it.
void TransmitPdos::request(std::size_t position, std::uint64_t payload) noexcept {
  const Outgoing& pdo = outgoing_[position];
  const TimePoint allowed = pdo.sent + pdo.inhibit;
  if (moment_ >= allowed) {
    transmit(position, payload);
  } else if (!is_armed(timer(position, Timer::Inhibit))) {
    arm(timer(position, Timer::Inhibit), cycle_.next_from(allowed));
  }
}

/// Sends an event-driven PDO.
void TransmitPdos::transmit(std::size_t position, std::uint64_t payload) noexcept {
  Outgoing& pdo = outgoing_[position];
  pdo.set_payload(payload);
  context_.sink->send(pdo.frame, Delivery::Replaceable);
  pdo.sent = moment_;
  if (pdo.inhibit.count() != 0) cancel(timer(position, Timer::Inhibit));
  if (pdo.event_period.count() != 0) {
    arm(timer(position, Timer::Event), pdo.sent + pdo.event_period);
  } else if (pdo.is_due) {
    cancel(timer(position, Timer::Event));  // the one that waits for the first cycle
  }
  pdo.is_due = false;
}

void TransmitPdos::on_timer(std::size_t which) noexcept {
  const std::size_t position = which / kTimersEach;
  Outgoing& pdo = outgoing_[position];
  const std::uint64_t payload = pack(pdo);
  begin_moment();
  if (which % kTimersEach == static_cast<std::size_t>(Timer::Event)) {
    pdo.is_due = true;
    request(position, payload);
  } else if (payload != pdo.payload() || pdo.is_due) {
    transmit(position, payload);
  }
}

void TransmitPdos::on_pdo_changed(std::size_t position) noexcept {
  Outgoing& pdo = outgoing_[position];
  for (const Timer which : {Timer::Event, Timer::Inhibit}) cancel(timer(position, which));
  note_last_sync(pdo);
  load_settings(position);
  sort_out();
  // As an event, so that the answer to the write comes first.
  if (running_ && pdo.trigger == Trigger::Event)
    arm(timer(position, Timer::Event), cycle_.next_from(context_.now));
}

void TransmitPdos::on_pdo_time_changed(std::size_t position, std::uint8_t sub_index, std::int64_t value) noexcept {
  Outgoing& pdo = outgoing_[position];
  if (sub_index == pdo_sub::kInhibitTime) pdo.inhibit = cycle_.whole(inhibit_time(value));
  if (sub_index != pdo_sub::kEventTimer) return;
  pdo.event_period = cycle_.whole(event_time(value));
  if (!running_ || pdo.trigger != Trigger::Event) return;
  if (value == 0) {
    cancel(timer(position, Timer::Event));
  } else {
    arm(timer(position, Timer::Event), cycle_.begin_of(context_.now) + pdo.event_period);
  }
}

}  // namespace canopen
