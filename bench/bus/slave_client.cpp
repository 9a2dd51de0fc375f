#include "bench/bus/slave_client.hpp"

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <poll.h>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPatience = 20'000;  // ms; a slave under an instruction counter is slow

can_frame frame(std::uint32_t identifier, std::uint8_t length) {
  can_frame result{};
  result.can_id = identifier;
  result.can_dlc = length;
  return result;
}

bool readable(const RawSocket& socket, int patience) {
  pollfd wanted{socket.descriptor(), POLLIN, 0};
  return ::poll(&wanted, 1, patience) == 1;
}

void send(const RawSocket& socket, const can_frame& wanted) {
  constexpr std::chrono::microseconds kPause{20};
  while (!socket.send(wanted)) {
    if (errno != ENOBUFS && errno != EAGAIN) throw std::runtime_error{"a frame cannot be sent"};
    std::this_thread::sleep_for(kPause);
  }
}

can_frame wait(const RawSocket& socket, const char* what) {
  can_frame answer{};
  if (!readable(socket, kPatience) || !socket.receive(answer)) throw std::runtime_error{std::string{"no "} + what};
  return answer;
}

}  // namespace

SlaveClient::SlaveClient(const Target& target)
    : target_{target},
      answers_{target.interface, std::array{only(0x580 + target.node)}},
      tpdos_{target.interface,
             std::array{same_function(0x180), same_function(0x280), same_function(0x380), same_function(0x480)}} {}

can_frame SlaveClient::ask(const can_frame& request) {
  send(answers_, request);
  return wait(answers_, "SDO answer");
}

can_frame SlaveClient::request(std::uint8_t command, Object object) const {
  constexpr std::uint8_t kLength = 8;
  can_frame result = frame(0x600 + target_.node, kLength);
  result.data[0] = command;
  std::memcpy(&result.data[1], &object.index, sizeof object.index);
  result.data[3] = object.sub_index;
  return result;
}

can_frame SlaveClient::upload(Object object) {
  constexpr std::uint8_t kUpload = 0x40;
  constexpr std::uint8_t kExpedited = 0x43;
  const can_frame wanted = request(kUpload, object);
  const can_frame answer = ask(wanted);
  if ((answer.data[0] & kExpedited) != kExpedited || std::memcmp(&answer.data[1], &wanted.data[1], 3) != 0)
    throw std::runtime_error{"an upload was not answered"};
  return answer;
}

void SlaveClient::download(Object object, std::uint32_t value, unsigned size) {
  constexpr unsigned kMost = 4;
  constexpr std::uint8_t kDone = 0x60;
  can_frame wanted = request(static_cast<std::uint8_t>(0x23U | (kMost - size) << 2), object);
  std::memcpy(&wanted.data[4], &value, sizeof value);
  if (ask(wanted).data[0] != kDone) throw std::runtime_error{"a download was refused"};
}

void SlaveClient::start_node() {
  can_frame start = frame(0, 2);
  start.data[0] = 1;
  start.data[1] = static_cast<std::uint8_t>(target_.node);
  send(answers_, start);
  upload({0x1000, 0});  // frames are handled one after the other
  for (can_frame event_driven{}; readable(tpdos_, 0);) tpdos_.receive(event_driven);
}

void SlaveClient::sync() {
  constexpr std::uint32_t kSync = 0x80;
  send(tpdos_, frame(kSync, 0));
  for (unsigned i = 0; i < target_.pdos; ++i) wait(tpdos_, "TPDO");
}

void SlaveClient::send_rpdo(std::uint32_t number) {
  constexpr std::uint8_t kLength = 7;
  can_frame rpdo = frame(0x200 + target_.node, kLength);
  std::memcpy(&rpdo.data[0], &target_.controlword, sizeof target_.controlword);
  std::memcpy(&rpdo.data[2], &number, sizeof number);
  send(answers_, rpdo);
}

std::vector<std::uint64_t> SlaveClient::heartbeats(std::chrono::nanoseconds time) {
  const RawSocket socket{target_.interface, std::array{only(0x700 + target_.node)}};
  std::vector<std::uint64_t> times;
  wait(socket, "heartbeat");
  Clock::time_point before = Clock::now();
  for (const Clock::time_point end = before + time; before < end;) {
    wait(socket, "heartbeat");
    const Clock::time_point now = Clock::now();
    times.push_back(static_cast<std::uint64_t>((now - before).count()));
    before = now;
  }
  return times;
}

std::uint64_t cpu_time(unsigned long process) {
  std::uint64_t sum = 0;
  for (const auto& thread : std::filesystem::directory_iterator{"/proc/" + std::to_string(process) + "/task"}) {
    std::ifstream file{thread.path() / "schedstat"};
    std::uint64_t on_cpu = 0;
    if (!(file >> on_cpu)) throw std::runtime_error{"no schedstat of the process"};
    sum += on_cpu;
  }
  return sum;
}

}  // namespace bench
