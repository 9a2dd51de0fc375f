#include <array>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/socket.h>

#include "can/userbus/time.hpp"
#include "tests/can/hub/running_hub.hpp"
#include "tests/can/hub/told.hpp"

namespace hub_test {
namespace {

/// Descriptors of this process, in which the hub is.
std::ptrdiff_t open_descriptors() {
  return std::distance(std::filesystem::directory_iterator{"/proc/self/fd"}, {});
}

/// True if no more than @p count descriptors remain; the hub closes that of a reply a little after its asker has
/// got it.
bool at_most_remain(std::ptrdiff_t count) {
  constexpr int kTries = 100'000;
  for (int i = 0; i < kTries; ++i) {
    if (open_descriptors() <= count) return true;
    std::this_thread::yield();
  }
  return false;
}

/// A message that has something of a right one, and something that is not right.
std::vector<std::byte> broken_message(std::mt19937& random) {
  constexpr std::array<std::size_t, 11> kSizes{0, 1, 12, 16, 20, 32, 40, 41, 80, 1280, 4000};
  std::vector<std::byte> bytes(random() % 4 == 0 ? random() % 10'000 : kSizes[random() % kSizes.size()]);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random() % 3 == 0 ? random() : 0);
  if (bytes.size() < sizeof(userbus::Request) || random() % 3 == 0) return bytes;
  userbus::Request request{.operation = static_cast<userbus::Operation>(random() % 16),
                           .value = random() % 2 == 0 ? static_cast<int>(random()) : 1001,
                           .size = static_cast<std::uint32_t>(bytes.size() - sizeof request)};
  std::memcpy(bytes.data(), &request, sizeof request);
  return bytes;
}

/// Somebody who takes turns as soon as it is owed them, and does nothing; without turns there is none.
class Idler {
 public:
  explicit Idler(const std::string& path)
      : clock_{userbus::join_clock(path_of(path), nullptr, 0, getpid(), false).descriptor} {
    thread_ = std::thread{[this] {
      userbus::TimeTurn turn{};
      userbus::TimeMessage message{};
      message.word = userbus::TimeMessage::Word::Wait;
      message.until_ns = userbus::kNoInstant;
      while (userbus::take_turn(clock_.get(), true, turn) == userbus::TurnOutcome::Turn)
        userbus::tell_time(clock_.get(), message);
    }};
  }
  Idler(const Idler&) = delete;
  Idler& operator=(const Idler&) = delete;
  ~Idler() {
    shutdown(clock_.get(), SHUT_RDWR);
    thread_.join();
  }

 private:
  os::Descriptor clock_;
  std::thread thread_;
};

class RandomMessages : public testing::TestWithParam<userbus::TimeMode> {};

TEST_P(RandomMessages, HarmNobodyButTheirSender) {
  const unsigned seed = told::seed();
  std::cout << "AXISD_TEST_SEED=" << seed << '\n';
  std::mt19937 random{seed};
  const bool has_turns = GetParam() == userbus::TimeMode::Virtual;
  RunningHub hub{hub::Server::Settings{.bit_rate = has_turns ? 1'000'000U : 0, .time = {GetParam(), 1}}};
  const Idler idler{hub.path()};
  BusClient talker{hub.path()};
  BusClient listener{hub.path()};
  constexpr std::array kStray{std::byte{1}};
  talker.send_with_descriptors(kStray,
                               1);  // the hub has a pipe from now on, to close them elsewhere
  talker.settle();
  const std::ptrdiff_t before = open_descriptors();

  for (int round = 0; round < 50; ++round) {
    BusClient stranger{hub.path(), random() % 2 == 0 ? "vcan0" : "",
                       random() % 3 == 0 ? userbus::Kind::Clock : userbus::Kind::Raw};
    const std::array<std::uint32_t, 1> frames_in_one{static_cast<std::uint32_t>(random() % 40)};
    if (random() % 2 == 0)
      static_cast<void>(stranger.ask(userbus::Operation::Hello, 0, std::as_bytes(std::span{frames_in_one})));
    for (int i = 0; i < 100; ++i)
      stranger.send_with_descriptors(broken_message(random), random() % 3 == 0 ? random() % 8 : 0);
    if (random() % 2 == 0) continue;  // some close before they are read
    stranger.settle();
    stranger.take();
  }
  listener.set_filters(std::array{can_filter{0x123, CAN_EFF_FLAG | CAN_RTR_FLAG | CAN_SFF_MASK}});
  listener.take();
  talker.send("123#AA");
  EXPECT_EQ(listener.wait_frame(), "123#AA");
  while (talker.ask(userbus::Operation::Statistics).error == 0) {
    userbus::BusStatistics bus{};
    std::memcpy(&bus, talker.reply().data(), sizeof bus);
    if (bus.members == 3) break;
  }
  EXPECT_TRUE(at_most_remain(before)) << open_descriptors() << " instead of " << before;
}

INSTANTIATE_TEST_SUITE_P(Times, RandomMessages,
                         testing::Values(userbus::TimeMode::Real, userbus::TimeMode::Virtual),
                         [](const auto& row) {
                           return row.param == userbus::TimeMode::Real ? "Real" : "Virtual";
                         });

}  // namespace
}  // namespace hub_test
