#include "can/hub/medium/medium.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "can/hub/medium/bit_time.hpp"
#include "can/hub/medium/station.hpp"

namespace hub {

Medium::Medium(std::uint32_t bit_rate, const Clock& clock) : clock_{clock}, line_{bit_rate, clock} {}

Medium::~Medium() = default;

void Medium::attach(Participant& participant) {
  auto station = std::make_unique<Station>(participant, attached_ + 1);
  stations_.reserve(stations_.size() + 1);
  waiting_.reserve(stations_.size() + 1);
  at_place_.resize((hearers_.words() + 1) * FilterIndex::kPlacesOfWord);
  station->place = hearers_.add();
  ++attached_;
  at_place_[station->place] = &participant;
  participant.station_ = station.get();
  stations_.push_back(std::move(station));
  hear_all(participant);
}

void Medium::hear_all(Participant& participant) noexcept {
  hearers_.take_all(participant.station_->place);
}

void Medium::hear(Participant& participant, const FilterSet& filters) noexcept {
  hearers_.take(participant.station_->place, filters);
}

void Medium::hear_nothing(Participant& participant) noexcept {
  hearers_.take_nothing(participant.station_->place);
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
  hearers_.take_nothing(station->place);
  at_place_[station->place] = nullptr;
  if (current_.sender == &participant) current_.sender = nullptr;
  someone_left_ = true;
  if (!advancing_) forget_those_who_left();
}

void Medium::withdraw(Participant& participant) noexcept {
  Station& station = *participant.station_;
  station.frames.clear();
  std::erase(waiting_, &station);
}

bool Medium::send(const Passage& passage, canopen::TimePoint now) noexcept {
  tell(now);
  if (!up_) {
    ++lost_;
    return true;
  }
  if (goes_on()) advance();
  Station& station = *passage.sender->station_;
  if (station.frames.full()) {
    station.refused = true;
    return false;
  }
  if (station.frames.empty()) waiting_.push_back(&station);
  station.frames.push({passage, now_, handed_over_++, arbitration_field(passage.frame)});
  Passage& kept = station.frames.last().content;
  kept.station = station.number;
  if (passage.mark.hub == 0) kept.mark = origins_.make();
  if (goes_on()) advance();
  return true;
}

canopen::TimePoint Medium::next_deadline() const noexcept {
  canopen::TimePoint own = on_wire_ ? line_.end() : waiting_.empty() ? canopen::kNever : now_;
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
  if (!clock_.is_told()) advance();
}

void Medium::tell(canopen::TimePoint now) noexcept {
  now_ = std::max(now_, now);
}

void Medium::advance() noexcept {
  advancing_ = true;
  if (carrier_ != nullptr)
    advance_with_carrier();
  else if (line_.bit_rate() == 0)
    advance_without_rate();
  else
    advance_with_rate();
  advancing_ = false;
  if (someone_left_) forget_those_who_left();
}

void Medium::advance_without_rate() noexcept {
  for (unsigned frames = 0; !waiting_.empty() && frames < kFramesOfTurn; ++frames) {
    take(*earliest_of(waiting_));
    deliver(clock_.wall());
  }
}

void Medium::advance_with_rate() noexcept {
  for (;;) {
    if (on_wire_) {
      if (line_.end() > now_) return;
      on_wire_ = false;
      deliver(line_.real_end());
      if (clock_.is_told()) return;  // who hears it may answer at this instant
      continue;                      // a frame that is repeated is on the wire again
    }
    if (waiting_.empty()) return;
    begin(std::max(line_.end(), earliest_of(waiting_)->frames.first().arrival));
  }
}

void Medium::advance_with_carrier() noexcept {
  const auto may_send = [this](const Station& station) { return carrier_->has_room(station.number); };
  while (Station* const next = earliest_of(waiting_, may_send)) {
    take(*next);
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
  waiting_.clear();
  for (const auto& station : stations_) {
    lost_ += station->frames.count();
    station->frames.clear();
    if (std::exchange(station->refused, false) && station->participant != nullptr) station->participant->on_room();
  }
  if (someone_left_) forget_those_who_left();
}

/// Makes the first frame of @p station the present one.
void Medium::take(Station& station) noexcept {
  current_ = station.frames.first().content;
  current_.sender = station.participant;
  if (station.participant == nullptr) left_ = station.left;
  station.frames.pop();
  if (station.frames.empty()) std::erase(waiting_, &station);
  if (std::exchange(station.refused, false) && station.participant != nullptr) station.participant->on_room();
}

/// Puts the frame that wins the arbitration at @p start on the wire.
void Medium::begin(canopen::TimePoint start) noexcept {
  on_wire_ = true;
  take(*winner_of(waiting_, start));
  line_.begin(current_.frame, start);
}

void Medium::deliver(std::int64_t time_ns) noexcept {
  current_.time_ns = time_ns;
  ++passed_;
  if (interference_ != nullptr) return interfere();
  spread(current_, [](const Participant&) { return true; });
}

/// Who comes while it passes does not hear it: the words are of before, and nobody gets a place that is left.
template <class Hears>
void Medium::spread(const Passage& passage, Hears hears) noexcept {
  hearers_.find(passage.frame.can_id);
  const std::size_t words = hearers_.words();
  for (std::size_t word = 0; word < words; ++word)
    for (std::uint64_t left = hearers_.found(word); left != 0; left &= left - 1) {
      const std::size_t place =
          word * FilterIndex::kPlacesOfWord + static_cast<std::size_t>(std::countr_zero(left));
      Participant* const participant = at_place_[place];
      if (participant != nullptr && hears(*participant)) participant->receive(passage);
    }
}

void Medium::interfere() noexcept {
  const canopen::TimePoint end = takes_time() ? line_.end() : now_;
  interference_->on_end(current_, current_.sender == nullptr ? left_ : current_.sender->identity(), end);
}

void Medium::hand_out(const Passage& passage, const Audience& audience) noexcept {
  spread(passage, [&audience](const Participant& participant) { return audience.hears(participant); });
}

void Medium::repeat() noexcept {
  current_.mark = origins_.make();
  if (!takes_time()) return deliver(clock_.wall());
  on_wire_ = true;
  line_.occupy(current_.frame);
}

void Medium::set_bit_rate(std::uint32_t bit_rate) noexcept {
  line_.set_bit_rate(bit_rate);
  if (bit_rate == 0 && std::exchange(on_wire_, false)) deliver(clock_.wall());
}

void Medium::forget_those_who_left() noexcept {
  const auto is_gone = [](const auto& station) {
    return station->participant == nullptr && station->frames.empty();
  };
  for (const auto& station : stations_)
    if (is_gone(station)) hearers_.remove(station->place);
  std::erase_if(stations_, is_gone);
  someone_left_ = std::any_of(stations_.begin(), stations_.end(),
                              [](const auto& station) { return station->participant == nullptr; });
}

}  // namespace hub
