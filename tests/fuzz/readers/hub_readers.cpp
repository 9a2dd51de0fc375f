// Messages that programs send to the hub of a bus in user space: what is wrong with them harms their sender alone.
#include <array>
#include <cstring>
#include <vector>

#include "can/userbus/time.hpp"
#include "tests/can/hub/running_hub.hpp"
#include "tests/fuzz/byte_source.hpp"
#include "tests/fuzz/readers/readers.hpp"

namespace fuzz {
namespace {

/// Messages of one input: a socket holds fewer than a hub is slow to read.
constexpr int kMostMessages = 64;
/// What a program can join as.
constexpr std::array kKinds{userbus::Kind::Raw, userbus::Kind::BroadcastManager, userbus::Kind::Port,
                            userbus::Kind::Clock};

/// A byte that says what a message is, and what that needs.
std::vector<std::byte> message_from(ByteSource& bytes) {
  constexpr std::uint8_t kRequest = 1;
  constexpr std::uint8_t kFrames = 2;
  const std::uint8_t what = bytes.u8();
  std::size_t size = bytes.u8();
  if (what % 4 == kFrames) size = sizeof(userbus::FrameMessage) * (1 + size % userbus::kMostFrames);
  std::vector<std::uint8_t> message(size);
  if (what % 4 == kRequest) {
    userbus::Request request{.operation = static_cast<userbus::Operation>(bytes.u8() % 20),
                             .value = static_cast<std::int16_t>(bytes.u16()),
                             .size = static_cast<std::uint32_t>(size)};
    message.resize(size + sizeof request);
    std::memcpy(message.data(), &request, sizeof request);
  }
  bytes.fill(std::span{message}.last(size));
  const auto all = std::as_bytes(std::span{message});
  return {all.begin(), all.end()};
}

/// Members of the bus that @p asker is on, itself among them.
std::uint32_t members(const hub_test::BusClient& asker) {
  userbus::BusStatistics bus{};
  if (asker.ask(userbus::Operation::Statistics).error != 0 || asker.reply().size() < sizeof bus) return 0;
  std::memcpy(&bus, asker.reply().data(), sizeof bus);
  return bus.members;
}

/// A bus whose hub runs in a thread of its own, and somebody on it who does everything right.
struct Bus {
  hub_test::RunningHub hub;
  hub_test::BusClient witness{hub.path()};

  std::string rule_of(Input input) {
    constexpr int kTries = 100'000;
    ByteSource bytes{std::span{reinterpret_cast<const std::uint8_t*>(input.data()), input.size()}};
    {
      const std::uint8_t first = bytes.u8();
      const hub_test::BusClient stranger{hub.path(), first % 2 == 0 ? "vcan0" : "",
                                         kKinds[first / 2 % kKinds.size()]};
      for (int i = 0; i < kMostMessages && !bytes.is_empty(); ++i) {
        const std::size_t descriptors = bytes.u8() % 4;
        stranger.send_with_descriptors(message_from(bytes), descriptors);
      }
    }
    for (int i = 0; i < kTries; ++i) {
      const std::uint32_t there = members(witness);
      static_cast<void>(witness.take());
      if (there == 1) return "";
      if (there == 0) return "the hub does not answer";
    }
    return "somebody who has left is still there";
  }
};

}  // namespace

std::string read_hub(Input input) {
  static Bus bus;
  return bus.rule_of(input);
}

std::vector<std::string> made_hub() {
  using namespace std::string_literals;
  return {"\x00\x01\x01\x04\x00\x00\x00\x20\x00\x00\x00"s + "\x00\x02\x00"s + std::string(40, '\1'),
          "\x01\x01\x01\x00\x01\xE9\x03"s + "\x01\x01\x08\x04\x00\x00\x23\x01\x00\x00\xFF\x07\x00\x00"s,
          "\x02\x01\x01\x38\x09\x00\x00"s + std::string(56, '\0')};
}

}  // namespace fuzz
