#include "tools/canopen-zoo/serve.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <system_error>

#include <fmt/format.h>
#include <poll.h>
#include <sys/signalfd.h>

#include "can/connection/connection.hpp"
#include "can/connection/transmit_queue.hpp"
#include "os/clock.hpp"
#include "os/descriptor.hpp"

namespace zoo {
namespace {

canopen::TimePoint read_clock() noexcept {
  return canopen::TimePoint{os::monotonic_time()};
}

/// SIGTERM and SIGINT, from now on readable instead of delivered.
os::Descriptor take_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGTERM, SIGINT}) sigaddset(&set, signal);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  os::Descriptor signals{::signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC)};
  if (!signals) throw std::system_error{errno, std::generic_category(), "signalfd"};
  return signals;
}

bus::Connection open_bus(const bus::Address& address) {
  bus::Connection connection = bus::open(address);
  const bus::LinkState state = connection.link->state();
  if (state == bus::LinkState::Up) return connection;
  throw bus::OpenError{address.text + (state == bus::LinkState::Gone ? " is not there" : " is down")};
}

/// A slave on a bus; it boots at once.
class Berth {
 public:
  Berth(const WrongSlave& slave, const bus::Address& address, std::uint8_t node_id)
      : name_{address.text},
        signals_{take_signals()},
        connection_{open_bus(address)},
        queue_{*connection_.port},
        slave_{slave.defect, node_id, read_clock()} {
    send_frames();
  }

  /// Until a signal comes.
  void run() {
    while (!wait()) turn();
  }

 private:
  /// Waits until there is something to do; true if a signal has come.
  bool wait() {
    enum { kSignals, kLink, kPort, kCount };
    std::array<pollfd, kCount> descriptors{pollfd{signals_.get(), POLLIN, 0},
                                           pollfd{connection_.link->descriptor(), POLLIN, 0},
                                           pollfd{connection_.port->descriptor(), POLLIN, 0}};
    constexpr canopen::Duration kLongest = std::chrono::hours{1};
    const canopen::Duration left = std::clamp(std::min(slave_.next_deadline(), queue_.next_retry()) - read_clock(),
                                              canopen::Duration::zero(), kLongest);
    const timespec limit = os::to_timespec(left);
    const nfds_t heard = queue_.accepts_input() && up_ ? kCount : kPort;
    (void)::ppoll(descriptors.data(), heard, &limit, nullptr);
    if (descriptors[kLink].revents != 0) follow_link();
    return descriptors[kSignals].revents != 0;
  }

  /// Hears, answers, and does what time brings.
  void turn() {
    queue_.retry(read_clock());
    canopen::Frame frame;
    for (bool more = up_; more && queue_.accepts_input();) {
      const bus::Received received = connection_.port->receive(frame);
      more = received.kind != bus::Received::Nothing && received.kind != bus::Received::Down;
      if (received.kind == bus::Received::Down) go_down();
      if (received.kind == bus::Received::Error && received.state == bus::ErrorState::BusOff)
        (void)connection_.port->restart();
      if (received.kind != bus::Received::Frame || frame.extended) continue;  // it has no use for 29 bits
      slave_.on_frame(frame, read_clock());
      send_frames();
    }
    if (const canopen::TimePoint now = read_clock(); now >= slave_.next_deadline()) slave_.on_time(now);
    send_frames();
  }

  void send_frames() {
    for (const canopen::Frame& frame : slave_.take_frames())
      if (up_) queue_.send(frame, canopen::Delivery::Ordered);
  }

  void go_down() {
    if (up_) fmt::print(stderr, "canopen-zoo: {} is down\n", name_);
    up_ = false;
    queue_.discard();
  }

  void follow_link() {
    if (!connection_.link->read()) return;
    if (connection_.link->state() != bus::LinkState::Up) return go_down();
    if (!connection_.port->reopen()) return;
    if (!up_) fmt::print(stderr, "canopen-zoo: {} is up again\n", name_);
    up_ = true;
    queue_.discard();
    slave_.node().command(canopen::NmtCommand::ResetNode, read_clock());
  }

  std::string name_;
  os::Descriptor signals_;
  bus::Connection connection_;
  bus::TransmitQueue queue_;
  Slave slave_;
  bool up_ = true;
};

}  // namespace

void serve(const WrongSlave& slave, const bus::Address& address, std::uint8_t node_id) {
  Berth berth{slave, address, node_id};
  fmt::print(stderr, "canopen-zoo: ready: node {} on {}: {}: {}\n", node_id, address.text, slave.name, slave.what);
  berth.run();
}

}  // namespace zoo
