#include "can/hub/medium/medium.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "can/hub/medium/bit_time.hpp"
#include "can/hub/medium/station.hpp"

namespace hub {

namespace {

constexpr std::uint64_t kNanosecondsOfSecond = 1'000'000'000;

std::int64_t real_time() noexcept {
  return std::chrono::nanoseconds{std::chrono::system_clock::now().time_since_epoch()}.count();
}

/// What makes a time of CLOCK_MONOTONIC one of CLOCK_REALTIME (ns).
std::int64_t real_minus_monotonic() noexcept {
  return real_time() - std::chrono::nanoseconds{std::chrono::steady_clock::now().time_since_epoch()}.count();
}

}  // namespace

Medium::Medium(std::uint32_t bit_rate) : bit_rate_{bit_rate} {}

Medium::~Medium() = default;

void Medium::attach(Participant& participant) {
  stations_.push_back(std::make_unique<Station>(participant));
  participant.station_ = stations_.back().get();
}

void Medium::detach(Participant& participant) noexcept {
  Station* const station = std::exchange(participant.station_, nullptr);
  if (station == nullptr) return;
  if (interference_ != nullptr) {
    station->left = participant.identity();
    if (current_.sender == &participant) left_ = station->left;
    interference_->on_detach(participant);
  }
  if (carrier_ != nullptr) carrier_->on_detach(participant);
  station->participant = nullptr;
  if (current_.sender == &participant) current_.sender = nullptr;
  someone_left_ = true;
  if (!advancing_) forget_those_who_left();
}

void Medium::withdraw(Participant& participant) noexcept {
  Station& station = *participant.station_;
  waiting_ -= station.count();
  station.clear();
}

bool Medium::send(const Passage& passage, canopen::TimePoint now) noexcept {
  tell(now);
  if (!up_) {
    ++lost_;
    return true;
  }
  if (!advancing_) advance();
  Station& station = *passage.sender->station_;
  if (station.full()) {
    station.refused = true;
    return false;
  }
  station.push({passage, now_, handed_over_++, arbitration_field(passage.frame)});
  if (passage.mark.hub == 0) station.last().passage.mark = origins_.make();
  ++waiting_;
  if (!advancing_) advance();
  return true;
}

canopen::TimePoint Medium::next_deadline() const noexcept {
  canopen::TimePoint own = on_wire_ ? end_of_frame() : waiting_ > 0 ? now_ : canopen::kNever;
  if (carrier_ != nullptr) own = canopen::kNever;
  return interference_ == nullptr ? own : std::min(own, interference_->next_deadline());
}

void Medium::on_time(canopen::TimePoint now) noexcept {
  tell(now);
  if (advancing_) return;
  advance();
  if (interference_ == nullptr || interference_->next_deadline() > now_) return;
  advancing_ = true;  // what is sent in answer to a late frame passes behind it
  interference_->on_time(now_);
  advancing_ = false;
  advance();
}

void Medium::tell(canopen::TimePoint now) noexcept {
  now_ = std::max(now_, now);
}

void Medium::advance() noexcept {
  advancing_ = true;
  if (carrier_ != nullptr)
    advance_with_carrier();
  else if (bit_rate_ == 0)
    advance_without_rate();
  else
    advance_with_rate();
  advancing_ = false;
  if (someone_left_) forget_those_who_left();
}

void Medium::advance_without_rate() noexcept {
  for (unsigned frames = 0; waiting_ > 0 && frames < kFramesOfTurn; ++frames) {
    take(*earliest());
    deliver(real_time());
  }
}

void Medium::advance_with_rate() noexcept {
  for (;;) {
    if (on_wire_) {
      const canopen::TimePoint end = end_of_frame();
      if (end > now_) return;
      on_wire_ = false;
      deliver(end.time_since_epoch().count() + to_real_time_);
      continue;  // a frame that is repeated is on the wire again
    }
    if (waiting_ == 0) return;
    begin(std::max(end_of_frame(), earliest()->first().arrival));
  }
}

void Medium::advance_with_carrier() noexcept {
  while (waiting_ > 0 && carrier_->has_room()) {
    take(*earliest());
    carrier_->take(current_, now_);
  }
}

void Medium::pass(const Passage& passage, canopen::TimePoint now) noexcept {
  tell(now);
  advancing_ = true;
  current_ = passage;
  if (interference_ != nullptr && passage.sender == nullptr) left_ = carrier_->identity();
  deliver(passage.time_ns);
  advance();
}

void Medium::go_on(canopen::TimePoint now) noexcept {
  tell(now);
  if (!advancing_) advance();
}

void Medium::set_up(bool up) noexcept {
  up_ = up;
  if (!up) lose_waiting();
}

/// Who was refused sends what it had kept, which is lost too.
void Medium::lose_waiting() noexcept {
  for (const auto& station : stations_) {
    lost_ += station->count();
    waiting_ -= station->count();
    station->clear();
    if (std::exchange(station->refused, false) && station->participant != nullptr) station->participant->on_room();
  }
  if (someone_left_) forget_those_who_left();
}

/// Who has the lowest arbitration field of those whose first frame was there at @p start; of equal ones that which
/// was handed over first.
Station* Medium::winner(canopen::TimePoint start) const noexcept {
  Station* best = nullptr;
  for (const auto& station : stations_) {
    if (station->empty() || station->first().arrival > start) continue;
    const Station::Waiting& candidate = station->first();
    if (best == nullptr ||
        std::pair{candidate.priority, candidate.number} < std::pair{best->first().priority, best->first().number})
      best = station.get();
  }
  return best;
}

/// Whose first frame was handed over before those of the others; nullptr if none waits.
Station* Medium::earliest() const noexcept {
  Station* best = nullptr;
  for (const auto& station : stations_)
    if (!station->empty() && (best == nullptr || station->first().number < best->first().number))
      best = station.get();
  return best;
}

/// Makes the first frame of @p station the present one.
void Medium::take(Station& station) noexcept {
  current_ = station.first().passage;
  current_.sender = station.participant;
  if (station.participant == nullptr) left_ = station.left;
  station.pop();
  --waiting_;
  if (std::exchange(station.refused, false) && station.participant != nullptr) station.participant->on_room();
}

/// Puts the frame that wins the arbitration at @p start on the wire.
void Medium::begin(canopen::TimePoint start) noexcept {
  if (start > end_of_frame()) {
    busy_since_ = start;
    busy_bits_ = 0;
    to_real_time_ = real_minus_monotonic();
  }
  on_wire_ = true;
  take(*winner(start));
  occupy(current_.frame);
}

/// The bus is busy for so much longer.
void Medium::occupy(const can_frame& frame) noexcept {
  busy_bits_ += bits_on_wire(frame);
  for (; busy_bits_ >= bit_rate_; busy_bits_ -= bit_rate_) busy_since_ += std::chrono::seconds{1};
}

void Medium::deliver(std::int64_t time_ns) noexcept {
  current_.time_ns = time_ns;
  ++passed_;
  if (interference_ != nullptr) return interfere();
  const std::size_t present = stations_.size();  // who comes while it passes does not see it
  for (std::size_t i = 0; i < present; ++i)
    if (Participant* const participant = stations_[i]->participant; participant != nullptr)
      participant->receive(current_);
}

void Medium::interfere() noexcept {
  const canopen::TimePoint end = bit_rate_ == 0 ? now_ : end_of_frame();
  interference_->on_end(current_, current_.sender == nullptr ? left_ : current_.sender->identity(), end);
}

void Medium::hand_out(const Passage& passage, const Audience& audience) noexcept {
  const std::size_t present = stations_.size();
  for (std::size_t i = 0; i < present; ++i)
    if (Participant* const participant = stations_[i]->participant;
        participant != nullptr && audience.hears(*participant))
      participant->receive(passage);
}

void Medium::repeat() noexcept {
  current_.mark = origins_.make();
  if (bit_rate_ == 0) return deliver(real_time());
  on_wire_ = true;
  occupy(current_.frame);
}

void Medium::set_bit_rate(std::uint32_t bit_rate) noexcept {
  if (bit_rate_ != 0) {
    busy_since_ = end_of_frame();
    busy_bits_ = 0;
  }
  bit_rate_ = bit_rate;
  if (bit_rate_ == 0 && std::exchange(on_wire_, false)) deliver(real_time());
}

void Medium::forget_those_who_left() noexcept {
  std::erase_if(stations_,
                [](const auto& station) { return station->participant == nullptr && station->empty(); });
  someone_left_ = std::any_of(stations_.begin(), stations_.end(),
                              [](const auto& station) { return station->participant == nullptr; });
}

canopen::TimePoint Medium::end_of_frame() const noexcept {
  return busy_since_ + canopen::Duration{busy_bits_ * kNanosecondsOfSecond / bit_rate_};
}

}  // namespace hub
