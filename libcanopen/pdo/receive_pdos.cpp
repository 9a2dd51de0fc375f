#include "libcanopen/pdo/receive_pdos.hpp"

#include <utility>

namespace canopen {
namespace {

/// Event timer in ms (CiA 301, 7.5.2.35).
constexpr Duration deadline_time(std::int64_t value) noexcept {
  return std::chrono::milliseconds{value};
}

/// How errors name an RPDO: 1 for 1400h.
constexpr std::uint16_t detail_of(std::uint16_t number) noexcept {
  return static_cast<std::uint16_t>(number + 1);
}

}  // namespace

ReceivePdos::ReceivePdos(Context& context)
    : Service{context,
              {.lives_in = kStatesOfPdo,
               .identifiers = PdoParameters::count_in(context.dictionary, Direction::Receive),
               .timers = PdoParameters::count_in(context.dictionary, Direction::Receive)}},
      image_{context.dictionary.image()},
      parameters_{context, Direction::Receive},
      incoming_(parameters_.pdos().size()) {
  parameters_.listen(*this);
  waiting_.reserve(incoming_.size());
}

void ReceivePdos::list_identifiers(IdentifierList& list) const noexcept {
  for (std::size_t position = 0; position < pdos().size(); ++position)
    list.hears(pdos()[position].identifier, position);
}

void ReceivePdos::on_frame(const Frame& frame, std::size_t position) noexcept {
  const Incoming& pdo = incoming_[position];
  if (frame.length != pdo.plain_length) return on_special(position, frame);
  apply(pdo, load<std::uint64_t>(frame.data.data()));
}

void ReceivePdos::reload(Reload) noexcept {
  stop();
  parameters_.reload();
  for (Incoming& pdo : incoming_) {
    end_timeout(pdo);
    report(pdo, Misfit::None);
    pdo = {};
  }
}

void ReceivePdos::claim_identifiers() noexcept {
  parameters_.claim_identifiers();
  for (std::size_t position = 0; position < incoming_.size(); ++position) load_settings(position);
}

void ReceivePdos::load_settings(std::size_t position) noexcept {
  const PdoSettings& settings = pdos()[position];
  Incoming& pdo = incoming_[position];
  pdo.plan = settings.is_active() ? settings.plan : MappingPlan{};
  pdo.number = settings.number;
  pdo.synchronous = settings.transmission_type <= kLastSynchronousType;
  pdo.period = deadline_time(parameters_.communication(settings, pdo_sub::kEventTimer));
  choose_path(pdo);
}

/// Frames of the mapped length take the short path if nothing else is to be thought of.
void ReceivePdos::choose_path(Incoming& pdo) noexcept {
  const bool plain =
      pdo.plan.length() != 0 && !pdo.synchronous && pdo.period.count() == 0 && pdo.misfit == Misfit::None;
  pdo.plain_length = plain ? pdo.plan.length() : kNoPlainLength;
}

void ReceivePdos::stop() noexcept {
  for (const std::uint16_t position : waiting_) incoming_[position].waits = false;
  waiting_.clear();
  window_end_ = kNever;
  for (std::size_t i = 0; i < incoming_.size(); ++i) cancel(i);
}

void ReceivePdos::on_special(std::size_t position, const Frame& frame) noexcept {
  Incoming& pdo = incoming_[position];
  if (pdo.plan.length() == 0) return;
  judge_length(pdo, frame);
  if (pdo.misfit == Misfit::TooShort) {
    ++too_short_;
    return;
  }
  end_timeout(pdo);
  if (context_.state != NmtState::Operational) return;  // the application's answer to an error, or to its end
  watch(position);
  const auto payload = load<std::uint64_t>(frame.data.data());
  if (pdo.synchronous) {
    latch(position, payload);
  } else {
    apply(pdo, payload);
  }
}

void ReceivePdos::judge_length(Incoming& pdo, const Frame& frame) noexcept {
  report(pdo, frame.length < pdo.plan.length()   ? Misfit::TooShort
              : frame.length > pdo.plan.length() ? Misfit::TooLong
                                                 : Misfit::None);
}

/// Reports the first frame of a wrong length, and the first right one after it (CiA 301, table "emergency error
/// codes": 8210h, 8220h).
void ReceivePdos::report(Incoming& pdo, Misfit misfit) noexcept {
  const auto error_of = [](Misfit m) {
    return m == Misfit::TooShort ? CommunicationError::RpdoTooShort : CommunicationError::RpdoTooLong;
  };
  if (pdo.misfit == misfit) return;
  const Misfit before = std::exchange(pdo.misfit, misfit);
  choose_path(pdo);
  if (before != Misfit::None) context_.errors.on_recovery(error_of(before), detail_of(pdo.number));
  if (misfit != Misfit::None) context_.errors.on_error(error_of(misfit), detail_of(pdo.number));
}

/// A frame has come: the next one is awaited within the event time, if there is one.
void ReceivePdos::watch(std::size_t position) noexcept {
  Incoming& pdo = incoming_[position];
  if (pdo.period.count() == 0) return;
  pdo.deadline = context_.now + pdo.period;
  if (!is_armed(position)) arm(position, pdo.deadline);
}

void ReceivePdos::end_timeout(Incoming& pdo) noexcept {
  if (!pdo.timed_out) return;
  pdo.timed_out = false;
  context_.errors.on_recovery(CommunicationError::RpdoTimeout, detail_of(pdo.number));
}

void ReceivePdos::on_timer(std::size_t position) noexcept {
  Incoming& pdo = incoming_[position];
  if (context_.now < pdo.deadline) return arm(position, pdo.deadline);
  pdo.timed_out = true;
  context_.errors.on_error(CommunicationError::RpdoTimeout, detail_of(pdo.number));
}

void ReceivePdos::latch(std::size_t position, std::uint64_t payload) noexcept {
  if (context_.now > window_end_) {
    ++too_late_;
    return;
  }
  Incoming& pdo = incoming_[position];
  pdo.latched = payload;
  if (pdo.waits) return;
  pdo.waits = true;
  waiting_.push_back(static_cast<std::uint16_t>(position));  // within the capacity reserved by the constructor
}

void ReceivePdos::on_sync(std::uint8_t, Duration window) noexcept {
  if (context_.state != NmtState::Operational) return;
  window_end_ = window.count() != 0 ? context_.now + window : kNever;
  if (context_.policy.sync_order == SyncOrder::ReceiveFirst) return apply_together();
  if (!waiting_.empty()) apply_waiting();
}

void ReceivePdos::apply_waiting() noexcept {
  // What a value causes may leave Operational, and stop() empties the list meanwhile.
  for (std::size_t i = 0; i < waiting_.size(); ++i) {  // NOLINT(modernize-loop-convert)
    Incoming& pdo = incoming_[waiting_[i]];
    pdo.waits = false;
    apply(pdo, pdo.latched);
  }
  waiting_.clear();
}

/// Stores all that waits before the application learns of any. What it does then may leave Operational.
void ReceivePdos::apply_together() noexcept {
  for (std::size_t i = 0; i < waiting_.size(); ++i) {  // NOLINT(modernize-loop-convert)
    Incoming& pdo = incoming_[waiting_[i]];
    pdo.waits = false;
    context_.application.before_rpdo(pdo.number);
    pdo.plan.unpack(pdo.latched, image_);
  }
  for (std::size_t i = 0; i < waiting_.size(); ++i)  // NOLINT(modernize-loop-convert)
    context_.application.on_rpdo(incoming_[waiting_[i]].number);
  waiting_.clear();
  if (context_.state == NmtState::Operational) context_.application.on_synchronous_rpdos();
}

void ReceivePdos::on_pdo_changed(std::size_t position) noexcept {
  Incoming& pdo = incoming_[position];
  if (pdo.waits) std::erase(waiting_, position);
  pdo.waits = false;
  cancel(position);
  end_timeout(pdo);
  report(pdo, Misfit::None);
  load_settings(position);
}

void ReceivePdos::on_pdo_time_changed(std::size_t position, std::uint8_t sub_index, std::int64_t value) noexcept {
  if (sub_index != pdo_sub::kEventTimer) return;
  Incoming& pdo = incoming_[position];
  pdo.period = deadline_time(value);
  choose_path(pdo);
  if (value == 0) {
    cancel(position);
    end_timeout(pdo);
  } else if (is_armed(position)) {
    pdo.deadline = context_.now + pdo.period;
    arm(position, pdo.deadline);
  }
}

}  // namespace canopen
