#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "can/port/port.hpp"

namespace fakes {

/// A bus port in memory: what is sent is kept, what is received comes from a queue, and a rule says what is
/// refused.
class FakePort final : public bus::Port {
 public:
  /// Status of the send call with this number (0..); all are sent while no rule is set.
  std::function<bus::SendStatus(std::size_t call)> rule;
  std::vector<canopen::Frame> sent;    ///< frames the bus has taken
  std::deque<canopen::Frame> arrived;  ///< frames that receive() will deliver
  std::vector<bus::Filter> filters;    ///< as last asked for
  std::size_t calls = 0;               ///< of send()
  bus::ErrorState state = bus::ErrorState::Active;
  bool down = false;                  ///< the next receive() tells so
  int polled = -1;                    ///< descriptor that tests make readable
  std::uint64_t reopened = 0;         ///< calls of reopen()
  bool gathers = false;               ///< frames are sent together, and come so
  std::vector<std::size_t> together;  ///< how many each call of send_all() was given

  std::optional<std::chrono::nanoseconds> arrival{};  ///< of what receive() delivers

  bus::SendStatus send(const canopen::Frame& frame) noexcept override {
    const bus::SendStatus status = rule ? rule(calls) : bus::SendStatus::Sent;
    ++calls;
    if (status == bus::SendStatus::Sent) sent.push_back(frame);
    return status;
  }
  bus::SentMany send_all(std::span<const canopen::Frame> frames) noexcept override {
    together.push_back(frames.size());
    return Port::send_all(frames);
  }
  bool sends_together() const noexcept override { return gathers; }
  bool has_frames() const noexcept override { return gathers && !arrived.empty(); }
  bus::Received receive(canopen::Frame& frame) noexcept override {
    if (std::exchange(down, false)) return {bus::Received::Down, state};
    if (arrived.empty()) return {bus::Received::Nothing, state};
    frame = arrived.front();
    arrived.pop_front();
    return {bus::Received::Frame, state};
  }
  std::optional<std::chrono::nanoseconds> frame_arrival() const noexcept override { return arrival; }
  bus::ErrorState error_state() const noexcept override { return state; }
  std::uint64_t dropped() const noexcept override { return 0; }
  int descriptor() const noexcept override { return polled; }
  void accept_only(std::span<const bus::Filter> wanted) noexcept override {
    filters.assign(wanted.begin(), wanted.end());
  }
  bool reopen() noexcept override {
    ++reopened;
    return true;
  }
};

}  // namespace fakes
