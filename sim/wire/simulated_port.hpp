#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "can/hub/medium/medium.hpp"
#include "can/port/link.hpp"
#include "can/port/port.hpp"
#include "sim/base/told_time.hpp"

namespace sim {

/// Who watches a port.
class PortListener {
 public:
  virtual ~PortListener() = default;
  /// Something waits at the port.
  virtual void on_arrival() noexcept = 0;
  /// The program behind the port has taken @p frame.
  virtual void on_taken(const canopen::Frame& frame) noexcept = 0;
  /// The bus has taken @p frame of it.
  virtual void on_sent(const canopen::Frame& frame) noexcept = 0;
};

/// A SocketCAN socket of a simulated bus, with its interface: frames that fit the filters wait in a receive buffer
/// of so many, the interface goes down and comes up, the controller has its error states.
class SimulatedPort final : public bus::Port, private hub::Participant {
 public:
  /// Frames that the receive buffer holds, as that of a kernel does.
  static constexpr std::size_t kReceiveBuffer = 480;

  /// At @p medium as @p identity, in @p time; all arguments outlive this.
  SimulatedPort(hub::Medium& medium, const ToldTime& time, const hub::Identity& identity, PortListener& listener);
  ~SimulatedPort() override;

  /// The interface goes down, or is up; bus::Port::reopen() follows the latter.
  void set_up(bool up) noexcept;
  /// The controller is in @p state from now on.
  void set_error_state(bus::ErrorState state) noexcept;
  /// Something waits to be received.
  [[nodiscard]] bool is_readable() const noexcept { return !arrived_.empty(); }

  // bus::Port
  bus::SendStatus send(const canopen::Frame& frame) noexcept override;
  bus::Received receive(canopen::Frame& frame) noexcept override;
  [[nodiscard]] std::optional<std::chrono::nanoseconds> frame_arrival() const noexcept override {
    return arrival_;
  }
  [[nodiscard]] bus::ErrorState error_state() const noexcept override { return state_; }
  [[nodiscard]] std::uint64_t dropped() const noexcept override { return dropped_; }
  [[nodiscard]] int descriptor() const noexcept override { return kDescriptor; }
  void accept_only(std::span<const bus::Filter> filters) noexcept override;
  bool reopen() noexcept override;
  bus::Restart restart() noexcept override;

 private:
  /// No descriptor of the system; nobody polls it.
  static constexpr int kDescriptor = 0;

  struct Arrived {
    bus::Received received;
    canopen::Frame frame;
    std::chrono::nanoseconds time;
  };
  // hub::Participant
  void receive(const hub::Passage& passage) noexcept override;
  [[nodiscard]] hub::Identity identity() const noexcept override { return identity_; }

  [[nodiscard]] bool accepts(const canopen::Frame& frame) const noexcept;
  void tell(const bus::Received& received) noexcept;

  hub::Medium& medium_;
  const ToldTime& time_;
  hub::Identity identity_;
  PortListener& listener_;
  std::vector<std::uint32_t> accepted_;  ///< sorted, as keys
  std::deque<Arrived> arrived_;
  std::optional<std::chrono::nanoseconds> arrival_{};
  bus::ErrorState state_ = bus::ErrorState::Active;
  std::uint64_t dropped_ = 0;
  bool up_ = true;
  bool open_ = false;
};

/// The state of that interface, as its program is told.
class SimulatedLink final : public bus::Link {
 public:
  /// The interface has changed.
  void change(bus::LinkState state) noexcept { changed_ = state; }
  /// read() has something to say.
  [[nodiscard]] bool is_readable() const noexcept { return changed_.has_value(); }

  // bus::Link
  [[nodiscard]] int descriptor() const noexcept override { return -1; }
  [[nodiscard]] std::optional<bus::LinkState> read() noexcept override {
    if (changed_) state_ = *changed_;
    return std::exchange(changed_, std::nullopt);
  }
  [[nodiscard]] bus::LinkState state() const noexcept override { return state_; }

 private:
  bus::LinkState state_ = bus::LinkState::Up;
  std::optional<bus::LinkState> changed_{};
};

}  // namespace sim
