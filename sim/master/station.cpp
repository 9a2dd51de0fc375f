#include "sim/master/station.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "can/port/wire.hpp"
#include "sim/base/allocations.hpp"
#include "sim/wire/identity.hpp"

namespace sim {
namespace {

/// From the end of a frame until a program has it in hand.
constexpr std::int64_t kQuickest = 20, kSlowest = 400;  // us

}  // namespace

void Station::Wait::await_suspend(std::coroutine_handle<> waiting) {
  waiting_ = waiting;
  station_.waits_.push_back(this);
  station_.due_ = std::min(station_.due_, until_);
}

Station::Station(hub::Medium& medium, std::string_view name, Draw draw)
    : medium_{medium}, identity_{identity_named(name)}, draw_{draw}, now_{medium.clock().now()} {
  medium_.attach(*this);
}

Station::~Station() {
  medium_.detach(*this);
}

void Station::send(const canopen::Frame& frame) noexcept {
  hub::Passage passage;
  passage.frame = bus::to_wire(frame);
  passage.sender = this;
  static_cast<void>(medium_.send(passage, now_));
}

void Station::receive(const hub::Passage& passage) noexcept {
  if (passage.sender == this || (passage.frame.can_id & CAN_ERR_FLAG) != 0) return;
  const Uncounted uncounted;
  const canopen::TimePoint at = medium_.now() + std::chrono::microseconds{draw_.between(kQuickest, kSlowest)};
  heard_.push_back({bus::from_wire(passage.frame), heard_.empty() ? at : std::max(at, heard_.back().at)});
  due_ = std::min(due_, heard_.back().at);
}

canopen::TimePoint Station::next_deadline() const noexcept {
  return due_ == canopen::kNever ? due_ : std::max(due_, stalled_until_);
}

canopen::TimePoint Station::earliest() const noexcept {
  canopen::TimePoint next = heard_.empty() ? canopen::kNever : heard_.front().at;
  for (const Wait* const wait : waits_) next = std::min(next, wait->until_);
  return next;
}

void Station::hear(const canopen::Frame& frame) {
  on_frame(frame);
  std::list<Wait*> fitting;
  for (auto wait = waits_.begin(); wait != waits_.end();) {
    const auto each = wait++;
    if ((*each)->fits_ != nullptr && (*(*each)->fits_)(frame)) fitting.splice(fitting.end(), waits_, each);
  }
  for (Wait* const wait : fitting) {
    wait->has_come_ = true;
    wait->waiting_.resume();
  }
}

void Station::turn(canopen::TimePoint now) {
  now_ = now;
  while (!heard_.empty() && heard_.front().at <= now_) {
    const canopen::Frame frame = heard_.front().frame;
    heard_.pop_front();
    hear(frame);
  }
  std::list<Wait*> over;
  for (auto wait = waits_.begin(); wait != waits_.end();) {
    const auto each = wait++;
    if ((*each)->until_ <= now_) over.splice(over.end(), waits_, each);
  }
  for (Wait* const wait : over) wait->waiting_.resume();
  due_ = earliest();
}

}  // namespace sim
