#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "can/hub/loop/timer.hpp"
#include "can/hub/medium/source.hpp"
#include "can/hub/member/core.hpp"
#include "can/hub/time/bus_time.hpp"
#include "can/userbus/name.hpp"
#include "os/descriptor.hpp"

namespace hub {

/// The loop of a hub: its members, its timers, and the sources beside them. One thread; nobody is waited for.
class Server final : public SourceList, private Watch, private BusEvents {
 public:
  /// How a hub behaves.
  struct Settings {
    std::uint32_t bit_rate = 0;  ///< bit/s, 0 = frames take no time
    bool on_demand = false;      ///< ends one second after its last member has left, or if none ever came
    userbus::TimeWish time{userbus::TimeMode::Real, 1};  ///< whose time it is
    BusTime::Settings turns{};                           ///< where it is not the machine's
  };

  /// Serves @p listener, a listening AF_UNIX SOCK_SEQPACKET socket that does not block and outlives this;
  /// std::system_error if the kernel has no descriptors or memory left.
  Server(int listener, Settings settings);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server() override;

  void add(Source& source) override;
  void remove(Source& source) noexcept override;

  /// The wire, for sources that take part.
  Medium& medium() noexcept { return core_.medium; }
  /// The names of the bus, likewise.
  Interfaces& interfaces() noexcept { return core_.interfaces; }

  /// The wire goes on beyond this hub from now on, and is cut: to be called before a trunk is made.
  void lengthen() { core_.link_page.create(); }
  /// The wire is whole or cut: members are told. What they have sent while it was cut is lost.
  void set_link(bool up) noexcept;

  /// The present of the bus.
  [[nodiscard]] canopen::TimePoint now() const noexcept { return core_.clock.now(); }
  /// What is wrong with the wire, likewise.
  faults::Faults& faults() noexcept { return core_.faults; }

  /// Serves until stop(), or until the end that Settings::on_demand asks for.
  void run() noexcept;
  /// Ends run() after the present turn; to be called from within it, by a source.
  void stop() noexcept { stopped_ = true; }

 private:
  class SourceWatch;

  void on_events(std::uint32_t events) noexcept override;
  void accept_members(canopen::TimePoint now) noexcept;
  void admit(os::Descriptor socket, userbus::Kind kind) noexcept;
  std::unique_ptr<Member> make_member(os::Descriptor socket, userbus::Kind kind);
  void pause_listening(canopen::TimePoint now) noexcept;
  [[nodiscard]] canopen::TimePoint next_event() const noexcept override;
  void have_events(canopen::TimePoint now) noexcept override;
  [[nodiscard]] bool is_event_due() const noexcept;
  [[nodiscard]] canopen::TimePoint next_machine_deadline() const noexcept;
  void on_machine_time(canopen::TimePoint now) noexcept;
  void wait() noexcept;
  void sweep(canopen::TimePoint now) noexcept;
  void end_if_lonely() noexcept;

  Core core_;
  std::optional<BusTime> time_;  // of a bus that has its own
  Timer timer_;
  int listener_;
  Settings settings_;
  std::size_t most_members_;
  std::vector<std::unique_ptr<SourceWatch>> watches_;
  std::vector<Member*> timed_;       // those that may have a deadline
  canopen::TimePoint listen_again_;  // kNever: it listens
  canopen::TimePoint end_;           // of a hub that nobody uses; kNever: it has members
  bool stopped_ = false;
  bool goes_on_ = false;  // time only took a pause
};

}  // namespace hub
