// A CANopen slave on a SocketCAN interface: example_slave INTERFACE NODE-ID
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <libcanopen/node/node.hpp>
#include <linux/can.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "example_application.hpp"
#include "example_objects.hpp"

/// The way to the bus. A real device keeps a frame that the socket refuses and sends it later.
struct Bus final : canopen::FrameSink {
  int descriptor = socket(PF_CAN, SOCK_RAW, CAN_RAW);
  void send(const canopen::Frame& frame, canopen::Delivery) override {
    can_frame out{};
    out.can_id = frame.id;
    out.len = frame.length;
    std::copy(frame.data.begin(), frame.data.end(), out.data);
    if (write(descriptor, &out, sizeof out) < 0) std::perror("write");
  }
};

const auto now = [] { return canopen::TimePoint{std::chrono::steady_clock::now().time_since_epoch()}; };

int main(int argc, char** argv) {
  const int node_id = argc == 3 ? std::atoi(argv[2]) : 0;
  if (node_id < 1 || node_id > 127) return std::fputs("usage: example_slave INTERFACE NODE-ID\n", stderr), 2;
  Bus bus;
  sockaddr_can address{AF_CAN, static_cast<int>(if_nametoindex(argv[1])), {}};
  if (address.can_ifindex == 0 || bind(bus.descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address) < 0)
    return std::perror(argv[1]), 1;

  canopen::Dictionary objects{kObjects, static_cast<std::uint8_t>(node_id)};
  Counter counter{objects};
  Document document;
  objects.own_domain(0x2001, 0, document);
  canopen::Node node{objects, canopen::Policy{.extended_identifiers = false}, bus, counter};  // 11 bits: see Bus
  for (node.start(now());; node.on_time(now())) {
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(node.next_deadline() - now());
    pollfd readable{bus.descriptor, POLLIN, 0};
    if (poll(&readable, 1, static_cast<int>(std::clamp<long>(wait.count(), 0, 60'000))) == 0) continue;
    can_frame in{};
    if (read(bus.descriptor, &in, sizeof in) < 0) return std::perror("read"), 1;
    if ((in.can_id & CAN_EFF_FLAG) != 0) continue;  // this device has no use for 29 bits
    const bool remote = (in.can_id & CAN_RTR_FLAG) != 0;
    canopen::Frame frame{.id = in.can_id & CAN_SFF_MASK, .length = in.len, .remote = remote};
    std::copy_n(in.data, frame.data.size(), frame.data.begin());
    node.on_frame(frame, now());
    node.on_values_changed(now());
  }
}
