#include "can/hub/trunk/lease/candidate.hpp"

#include <algorithm>
#include <utility>

namespace hub::trunk {

using canopen::TimePoint;

void Candidate::begin(TimePoint now) noexcept {
  quiet_since_ = now;
  entry_.reset();
  is_asking_ = false;
  wanted_ = 0;
}

std::optional<std::uint32_t> Candidate::seek(std::uint32_t known, TimePoint now) noexcept {
  if (const auto gained = take_answer(now)) return gained;
  if (is_asking_ || next_deadline(known) > now) return std::nullopt;
  is_asking_ = true;
  if (entry_) {
    wanted_ = std::max(entry_->term, known) + 1;
    lease_.take(entry_->revision, wanted_);
  } else {
    lease_.look();
  }
  return take_answer(now);
}

std::optional<std::uint32_t> Candidate::take_answer(TimePoint now) noexcept {
  if (!is_asking_) return std::nullopt;
  const auto answer = lease_.take_answer();
  next_look_ = now + kLook;
  if (!answer) return std::nullopt;
  is_asking_ = false;
  if (!entry_ || entry_->revision != answer->revision) entry_since_ = now;
  entry_ = answer;
  const std::uint32_t wanted = std::exchange(wanted_, 0);
  if (wanted == 0 || answer->hub != hub_ || answer->term != wanted) return std::nullopt;
  quiet_since_ = now;
  return wanted;
}

/// Whoever has taken the lease for a term that was not heard of gets time to speak.
TimePoint Candidate::next_deadline(std::uint32_t known) const noexcept {
  if (is_asking_) return next_look_;
  if (!entry_) return quiet_since_ + kLookAfter;
  const bool may_speak = entry_->term > known && entry_->hub != hub_;
  return may_speak ? std::max(quiet_at(), entry_since_ + patience_) : quiet_at();
}

}  // namespace hub::trunk
