#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <sys/signalfd.h>

#include "bench/number.hpp"
#include "bench/operations/library_node.hpp"
#include "can/port/socketcan/socket_can.hpp"
#include "daemon/loop/event_loop.hpp"
#include "service/clock.hpp"

namespace {

struct Arguments {
  std::string interface;
  unsigned node = 0;
  unsigned pdos = 4;
  bool operational = false;
};

/// SIGTERM and SIGINT, taken from a descriptor instead of delivered.
class Signals {
 public:
  Signals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGTERM, SIGINT}) sigaddset(&set, signal);
    sigprocmask(SIG_BLOCK, &set, nullptr);
    descriptor_ = os::Descriptor{::signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC)};
    if (!descriptor_) throw std::system_error{errno, std::generic_category(), "signalfd"};
  }
  int descriptor() const noexcept { return descriptor_.get(); }
  /// True if one has come.
  bool take() const noexcept {
    signalfd_siginfo signal{};
    return ::read(descriptor_.get(), &signal, sizeof signal) == sizeof signal;
  }

 private:
  os::Descriptor descriptor_;
};

/// A plain node of the library on the daemon's loop.
class Slave final : private axisd::Station, private axisd::Service, private canopen::Application {
 public:
  explicit Slave(const Arguments& arguments)
      : table_{bench::library_table({.pdos = static_cast<std::uint16_t>(arguments.pdos)})},
        dictionary_{table_, static_cast<std::uint8_t>(arguments.node)},
        port_{arguments.interface},
        bus_{port_, *this},
        node_{dictionary_,
              {.start_state =
                   arguments.operational ? canopen::NmtState::Operational : canopen::NmtState::PreOperational},
              bus_.queue(),
              *this} {
    loop_.add(bus_);
    loop_.watch(signals_.descriptor());
    if (!bus_.open()) throw bus::OpenError{arguments.interface + " is down"};
  }
  void serve() {
    node_.start(axisd::read_clock());
    std::fputs("ready\n", stderr);
    while (!stopped_) loop_.turn();
    std::fprintf(stderr, "rpdos %lu\ndropped %lu\n", rpdos_, static_cast<unsigned long>(bus_.port().dropped()));
  }

 private:
  void on_frame(const canopen::Frame& frame, canopen::TimePoint now) noexcept override {
    node_.on_frame(frame, now);
  }
  void on_time(canopen::TimePoint now) noexcept override { node_.on_time(now); }
  canopen::TimePoint next_deadline() const noexcept override { return node_.next_deadline(); }
  std::span<const canopen::Subscription> subscriptions() const noexcept override { return node_.subscriptions(); }
  bool on_rare_event() noexcept override { return stopped_ |= signals_.take(), false; }
  void on_link_lost() noexcept override { stopped_ = true; }

  void on_subscriptions_changed() noexcept override { bus_.follow_subscriptions(); }
  void on_rpdo(std::uint16_t) noexcept override { ++rpdos_; }

  std::vector<canopen::EntryDescription> table_;
  canopen::Dictionary dictionary_;
  Signals signals_;
  bus::SocketCan port_;
  axisd::BusTurn bus_;
  canopen::Node node_;
  axisd::EventLoop loop_{*this};
  unsigned long rpdos_ = 0;
  bool stopped_ = false;
};

/// Nothing if the words make no sense.
std::optional<Arguments> parse(int count, char** words) {
  constexpr unsigned kHighestNode = 127;
  constexpr unsigned kMostPdos = 64;
  Arguments arguments;
  if (count < 3 || !bench::parse(words[2], 1U, kHighestNode, arguments.node)) return std::nullopt;
  arguments.interface = words[1];
  for (int i = 3; i < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--operational") {
      arguments.operational = true;
    } else if (word != "--pdos" || ++i == count || !bench::parse(words[i], 1U, kMostPdos, arguments.pdos)) {
      return std::nullopt;
    }
  }
  return arguments;
}

}  // namespace

/// Puts a node of libcanopen on a CAN interface: 1,500 objects, 4 or 64 PDOs of each direction, the daemon's loop.
/// At its end it tells how many RPDOs it took and how many frames its socket lost.
int main(int count, char** words) {
  constexpr int kUsage = 2;
  const std::optional<Arguments> arguments = parse(count, words);
  if (!arguments) {
    std::fputs("usage: bus_slave INTERFACE NODE [--pdos 1..64] [--operational]\n", stderr);
    return kUsage;
  }
  try {
    Slave{*arguments}.serve();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bus_slave: %s\n", error.what());
    return 1;
  }
}
