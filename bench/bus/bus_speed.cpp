#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "bench/bus/raw_socket.hpp"
#include "bench/number.hpp"

/// What a CAN bus of this machine carries, whatever it is made of: round trips between two sockets, and frames a
/// second from one socket to all others.
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kUsage = 2;
constexpr std::uint32_t kData = 0x100;   // of the sender, to all
constexpr std::uint32_t kEnd = 0x101;    // behind the last of a burst
constexpr std::uint32_t kReady = 0x200;  // of a receiver that has seen it
constexpr unsigned kBurst = 100;         // fits into every receive buffer

can_frame frame_of(std::uint32_t identifier) {
  can_frame frame{};
  frame.can_id = identifier;
  frame.can_dlc = CAN_MAX_DLEN;
  return frame;
}

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error{what};
}

/// Answers every frame until the sender says that it was the last one (data[0] not 0).
void answer(const bench::RawSocket& socket) {
  for (can_frame frame{}; frame.data[0] == 0;) {
    if (!socket.receive(frame) || !socket.send(frame_of(kReady))) fail("the other end of the round trip");
  }
}

void measure_round_trips(const char* interface, unsigned long count) {
  const can_filter data = bench::only(kData);
  const can_filter ready = bench::only(kReady);
  const bench::RawSocket server{interface, {&data, 1}};
  const bench::RawSocket client{interface, {&ready, 1}};
  std::thread thread{[&server] { answer(server); }};
  std::vector<std::int64_t> times(count);
  for (unsigned long i = 0; i < count; ++i) {
    can_frame request = frame_of(kData);
    request.data[0] = i + 1 == count ? 1 : 0;
    const Clock::time_point before = Clock::now();
    if (!client.send(request) || !client.receive(request)) fail("no answer");
    times[i] = std::chrono::nanoseconds{Clock::now() - before}.count();
  }
  thread.join();
  std::sort(times.begin(), times.end());
  std::printf("round_trip_p50_ns %lld\n", static_cast<long long>(times[count / 2]));
  std::printf("round_trip_p99_ns %lld\n", static_cast<long long>(times[count * 99 / 100]));
}

/// Counts what comes, and answers the end of each of @p bursts; the number of frames.
unsigned long receive_bursts(const bench::RawSocket& socket, unsigned long bursts) {
  unsigned long frames = 0;
  while (bursts != 0) {
    can_frame frame{};
    if (!socket.receive(frame)) fail("a receiver");
    if (frame.can_id == kData) ++frames;
    if (frame.can_id != kEnd) continue;
    --bursts;
    if (!socket.send(frame_of(kReady))) fail("a receiver cannot answer");
  }
  return frames;
}

/// One sender, @p members - 1 receivers; the sender waits for all of them behind every burst, so that none is
/// lost.
void measure_frames(const char* interface, unsigned long members, unsigned long bursts) {
  const can_filter to_receivers{.can_id = kData, .can_mask = CAN_SFF_MASK & ~1U};
  const can_filter ready = bench::only(kReady);
  std::vector<std::unique_ptr<bench::RawSocket>> sockets;
  for (unsigned long i = 1; i < members; ++i)
    sockets.push_back(std::make_unique<bench::RawSocket>(interface, std::span{&to_receivers, 1}));
  const bench::RawSocket sender{interface, {&ready, 1}};
  std::vector<unsigned long> received(sockets.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < sockets.size(); ++i)
    threads.emplace_back([&, i] { received[i] = receive_bursts(*sockets[i], bursts); });

  const Clock::time_point before = Clock::now();
  for (unsigned long burst = 0; burst < bursts; ++burst) {
    for (unsigned i = 0; i < kBurst; ++i)
      if (!sender.send(frame_of(kData))) fail("the sender");
    can_frame frame = frame_of(kEnd);
    if (!sender.send(frame)) fail("the sender");
    for (std::size_t i = 0; i < sockets.size(); ++i)
      if (!sender.receive(frame)) fail("the sender hears nothing");
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - before).count();
  for (std::thread& thread : threads) thread.join();

  const double frames = static_cast<double>(bursts) * kBurst;
  unsigned long lost = 0;
  for (const unsigned long count : received) lost += bursts * kBurst - count;
  std::printf("frames_a_second %.0f\n", frames / seconds);
  std::printf("deliveries_a_second %.0f\n", frames * static_cast<double>(sockets.size()) / seconds);
  std::printf("lost %lu\n", lost);
}

}  // namespace

int main(int count, char** words) {
  constexpr int kWords = 5;
  unsigned long members = 0;
  unsigned long bursts = 0;
  unsigned long round_trips = 0;
  if (count != kWords || !bench::parse(words[2], 2UL, 1000UL, members) ||
      !bench::parse(words[3], 1UL, 1'000'000UL, bursts) ||
      !bench::parse(words[4], 1UL, 100'000'000UL, round_trips)) {
    std::fprintf(stderr, "usage: bus_speed INTERFACE MEMBERS BURSTS ROUND-TRIPS (a burst has %u frames)\n",
                 kBurst);
    return kUsage;
  }
  try {
    measure_round_trips(words[1], round_trips);
    measure_frames(words[1], members, bursts);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bus_speed: %s\n", error.what());
    return 1;
  }
  return 0;
}
