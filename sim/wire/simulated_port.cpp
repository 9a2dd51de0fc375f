#include "sim/wire/simulated_port.hpp"

#include <algorithm>
#include <utility>

#include "can/port/wire.hpp"
#include "sim/base/allocations.hpp"

namespace sim {
namespace {

constexpr std::uint32_t key(std::uint32_t identifier, bool remote, bool extended) noexcept {
  return identifier << 2U | (remote ? 2U : 0U) | (extended ? 1U : 0U);
}

}  // namespace

SimulatedPort::SimulatedPort(hub::Medium& medium, const ToldTime& time, const hub::Identity& identity,
                             PortListener& listener)
    : medium_{medium}, time_{time}, identity_{identity}, listener_{listener} {
  medium_.attach(*this);
}

SimulatedPort::~SimulatedPort() {
  medium_.withdraw(*this);
  medium_.detach(*this);
}

/// What waits for the bus is lost with the interface, as with a driver that flushes its queue.
void SimulatedPort::set_up(bool up) noexcept {
  if (std::exchange(up_, up) == up) return;
  if (up) return;
  medium_.withdraw(*this);
  if (open_) tell({.kind = bus::Received::Down, .state = state_});
  open_ = false;
}

void SimulatedPort::set_error_state(bus::ErrorState state) noexcept {
  if (std::exchange(state_, state) == state) return;
  if (state == bus::ErrorState::BusOff) medium_.withdraw(*this);
  if (open_) tell({.kind = bus::Received::Error, .state = state});
}

void SimulatedPort::tell(const bus::Received& received) noexcept {
  const Uncounted uncounted;
  arrived_.push_back({received, {}, time_.wall()});
  listener_.on_arrival();
}

bus::SendStatus SimulatedPort::send(const canopen::Frame& frame) noexcept {
  const Uncounted uncounted;
  if (!up_ || !open_) return bus::SendStatus::Down;
  if (state_ == bus::ErrorState::BusOff) return bus::SendStatus::Full;
  hub::Passage passage;
  passage.frame = bus::to_wire(frame);
  passage.sender = this;
  if (!medium_.send(passage, time_.now())) return bus::SendStatus::Full;
  listener_.on_sent(frame);
  return bus::SendStatus::Sent;
}

bus::Received SimulatedPort::receive(canopen::Frame& frame) noexcept {
  const Uncounted uncounted;
  if (arrived_.empty()) return {.kind = bus::Received::Nothing, .state = state_};
  const Arrived arrived = arrived_.front();
  arrived_.pop_front();
  if (arrived.received.kind == bus::Received::Frame) {
    frame = arrived.frame;
    arrival_ = arrived.time;
    listener_.on_taken(frame);
  }
  return arrived.received;
}

void SimulatedPort::receive(const hub::Passage& passage) noexcept {
  if (passage.sender == this || !open_ || state_ == bus::ErrorState::BusOff) return;
  if ((passage.frame.can_id & CAN_ERR_FLAG) != 0) return;
  const canopen::Frame frame = bus::from_wire(passage.frame);
  if (!accepts(frame)) return;
  const Uncounted uncounted;
  if (arrived_.size() >= kReceiveBuffer) {
    ++dropped_;
    return;
  }
  arrived_.push_back({{.kind = bus::Received::Frame, .state = state_}, frame, time_.wall()});
  listener_.on_arrival();
}

bool SimulatedPort::accepts(const canopen::Frame& frame) const noexcept {
  return std::ranges::binary_search(accepted_, key(frame.id, frame.remote, frame.extended));
}

void SimulatedPort::accept_only(std::span<const bus::Filter> filters) noexcept {
  const Uncounted uncounted;
  accepted_.clear();
  for (const bus::Filter& filter : filters)
    accepted_.push_back(key(filter.identifier, filter.remote, filter.extended));
  std::ranges::sort(accepted_);
}

bool SimulatedPort::reopen() noexcept {
  const Uncounted uncounted;
  arrived_.clear();
  arrival_.reset();
  open_ = up_;
  return open_;
}

bus::Restart SimulatedPort::restart() noexcept {
  if (state_ != bus::ErrorState::BusOff) return bus::Restart::Done;
  set_error_state(bus::ErrorState::Active);
  return bus::Restart::Started;
}

}  // namespace sim
