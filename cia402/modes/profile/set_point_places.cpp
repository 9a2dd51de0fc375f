#include "cia402/modes/profile/set_point_places.hpp"

#include "cia402/base/word_bits.hpp"

namespace cia402 {

bool SetPointPlaces::takes(std::uint16_t word, std::uint16_t former) const noexcept {
  using Bits = ProfilePositionBits;
  if (!has(word, Bits::kNewSetPoint) || has(former, Bits::kNewSetPoint) || has(word, Bits::kHalt)) return false;
  return !acknowledges_ || (waiting_ && has(word, Bits::kChangeImmediately));
}

SetPointPlaces::Taken SetPointPlaces::controlword(std::uint16_t word, std::uint16_t former,
                                                  const ProfilePositionSettings& settings) noexcept {
  using Bits = ProfilePositionBits;
  new_set_point_ = has(word, Bits::kNewSetPoint);
  if (!takes(word, former)) {
    release(!new_set_point_ && has(former, Bits::kNewSetPoint));
    return Taken::None;
  }
  const SetPoint set_point = make_set_point(word, settings);
  acknowledges_ = true;
  response_ = set_point.response;
  if (running_ && !has(word, Bits::kChangeImmediately)) {
    waiting_ = set_point;
    return Taken::Waiting;
  }
  running_ = set_point;
  waiting_.reset();
  return Taken::Running;
}

/// Ends the acknowledgement if it is over; @p falls: bit 4 has just become 0.
void SetPointPlaces::release(bool falls) noexcept {
  if (waiting_) return;
  switch (response_) {
    case SetPoint::Response::Reached:
      if (!running_) acknowledges_ = false;
      break;
    case SetPoint::Response::FallAfterReached:
      if (!running_ && falls) acknowledges_ = false;
      break;
    default:
      if (!new_set_point_) acknowledges_ = false;
  }
}

void SetPointPlaces::reach() noexcept {
  running_.reset();
  release(false);
}

void SetPointPlaces::advance() noexcept {
  running_ = waiting_;
  waiting_.reset();
  release(false);
}

void SetPointPlaces::clear() noexcept {
  running_.reset();
  waiting_.reset();
  acknowledges_ = false;
}

}  // namespace cia402
