#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include <poll.h>

#include "bench/raw_socket.hpp"

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kHeartbeat{100};

volatile std::sig_atomic_t stopped = 0;

/// The answer to every upload request, without a look at what is asked for.
can_frame answer_to(const can_frame& request, unsigned node) {
  can_frame answer = request;
  answer.can_id = 0x580 + node;
  answer.data[0] = 0x43;
  return answer;
}

/// A heartbeat, and a poll, a read and a write for every request: what the transport alone costs.
void serve(const bench::RawSocket& socket, unsigned node) {
  can_frame heartbeat{};
  heartbeat.can_id = 0x700 + node;
  heartbeat.can_dlc = 1;
  pollfd wait{socket.descriptor(), POLLIN, 0};
  for (Clock::time_point due = Clock::now(); stopped == 0;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(due - Clock::now());
    if (left.count() <= 0) {
      socket.send(heartbeat);
      due += kHeartbeat;
      continue;
    }
    can_frame request{};
    if (::poll(&wait, 1, static_cast<int>(left.count())) != 1 || !socket.receive(request)) continue;
    socket.send(answer_to(request, node));
  }
}

}  // namespace

/// The plainest slave there can be, to compare with.
int main(int count, char** words) {
  if (count != 3) {
    std::fputs("usage: can_echo INTERFACE NODE\n", stderr);
    return 2;
  }
  std::signal(SIGTERM, [](int) { stopped = 1; });
  try {
    const auto node = static_cast<unsigned>(std::atoi(words[2]));
    const bench::RawSocket socket{words[1], 0x600 + node};
    std::fputs("ready\n", stderr);
    serve(socket, node);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "can_echo: %s\n", error.what());
    return 1;
  }
}
