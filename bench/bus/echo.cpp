#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>

#include <poll.h>

#include "bench/bus/raw_socket.hpp"
#include "bench/number.hpp"

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kHeartbeat{100};
constexpr std::uint32_t kSync = 0x80;
constexpr std::uint32_t kFirstTpdo = 0x281;
constexpr std::uint8_t kTpdoLength = 6;

volatile std::sig_atomic_t stopped = 0;

/// What the transport alone costs: a heartbeat, and a poll, a read and the writes for every frame.
class Echo {
 public:
  Echo(const char* interface, unsigned node, unsigned tpdos)
      : node_{node},
        tpdos_{tpdos},
        filters_{bench::only(0), bench::only(kSync), bench::only(0x200 + node), bench::only(0x600 + node)},
        socket_{interface, filters_} {}

  void serve() {
    can_frame heartbeat{};
    heartbeat.can_id = 0x700 + node_;
    heartbeat.can_dlc = 1;
    pollfd wait{socket_.descriptor(), POLLIN, 0};
    for (Clock::time_point due = Clock::now(); stopped == 0;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(due - Clock::now());
      if (left.count() <= 0) {
        socket_.send(heartbeat);
        due += kHeartbeat;
        continue;
      }
      can_frame frame{};
      if (::poll(&wait, 1, static_cast<int>(left.count())) == 1 && socket_.receive(frame)) take(frame);
    }
  }
  unsigned long rpdos() const noexcept { return rpdos_; }

 private:
  void take(const can_frame& frame) {
    if (frame.can_id == 0x600 + node_) {
      answer(frame);
    } else if (frame.can_id == kSync) {
      send_tpdos();
    } else if (frame.can_id != 0) {
      ++rpdos_;
    }
  }
  /// The answer to every request, without a look at what is asked for.
  void answer(const can_frame& request) {
    constexpr std::uint8_t kUpload = 0x40;
    can_frame response = request;
    response.can_id = 0x580 + node_;
    response.data[0] = request.data[0] == kUpload ? 0x43 : 0x60;
    socket_.send(response);
  }
  void send_tpdos() {
    can_frame tpdo{};
    tpdo.can_dlc = kTpdoLength;
    for (unsigned i = 0; i < tpdos_; ++i) {
      tpdo.can_id = kFirstTpdo + i;
      socket_.send(tpdo);
    }
  }

  unsigned node_;
  unsigned tpdos_;
  std::array<can_filter, 4> filters_;
  bench::RawSocket socket_;
  unsigned long rpdos_ = 0;
};

}  // namespace

/// The plainest slave there can be, to compare with: it answers every SDO request with the request, and every SYNC
/// with as many frames as it is told. At its end it tells how many RPDOs it took.
int main(int count, char** words) {
  constexpr int kUsage = 2;
  constexpr unsigned kHighestNode = 127;
  constexpr unsigned kMostTpdos = 512;
  unsigned node = 0;
  unsigned tpdos = 4;
  if ((count != 3 && count != 4) || !bench::parse(words[2], 1U, kHighestNode, node) ||
      (count == 4 && !bench::parse(words[3], 1U, kMostTpdos, tpdos))) {
    std::fputs("usage: can_echo INTERFACE NODE [TPDOS]\n", stderr);
    return kUsage;
  }
  std::signal(SIGTERM, [](int) { stopped = 1; });
  try {
    Echo echo{words[1], node, tpdos};
    std::fputs("ready\n", stderr);
    echo.serve();
    std::fprintf(stderr, "rpdos %lu\n", echo.rpdos());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "can_echo: %s\n", error.what());
    return 1;
  }
}
