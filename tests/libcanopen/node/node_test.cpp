#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>

#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

using canopen::Frame;

class Node : public NodeTest {};

TEST_F(Node, ListensToItsServicesOnly) {
  start();

  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0, 0x80, 0x205, 0x305, 0x405, 0x585, 0x605, 0x705}));
}

TEST_F(Node, TellsOfFramesThatOnlyItselfMaySend) {
  start();

  says("585#4300100092010200");
  says("705#7F");
  says("705#R");  // a master that guards is no second node
  says("706#7F");

  EXPECT_EQ(application.foreign, (std::vector<std::uint32_t>{0x585, 0x705}));
}

TEST_F(Node, KeepsServingWhenAnotherNodeUsesItsIdentifiers) {
  start();
  says("705#00");

  EXPECT_EQ(says("605#4018100100000000"), (Lines{"585#431810012A000000"}));
}

TEST_F(Node, HasNoDeadlineWhileNothingIsPending) {
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
  start_operational();
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(Node, WorksWithoutTheObjectsOfOptionalServices) {
  const std::array table{canopen::EntryDescription{.index = 0x1000, .type = canopen::DataType::Unsigned32}};
  canopen::Dictionary small{table, 127};
  canopen::Node bare{small, {}, bus, application};

  bare.start(now);
  bare.on_frame(fakes::frame_of("000#017F"), now);
  bare.on_frame(fakes::frame_of("080#"), now);
  bare.on_frame(fakes::frame_of("67F#4000100000000000"), now);
  bare.send_emcy(0x1000, 1, {});

  EXPECT_EQ(sent(), (Lines{"77F#00", "5FF#4300100000000000", "0FF#0010010000000000"}));
}

/// Frames of any content, drawn so that most of them reach a service.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_{seed} {}

  std::uint64_t below(std::uint64_t limit) { return random_() % limit; }

  Frame frame(std::span<const std::uint32_t> subscriptions) {
    Frame frame;
    frame.id = below(8) == 0 || subscriptions.empty() ? static_cast<std::uint32_t>(random_())
                                                      : subscriptions[below(subscriptions.size())];
    if (below(2) == 0) frame.id = 0x605;
    frame.length = static_cast<std::uint8_t>(below(4) == 0 ? below(256) : 8);
    frame.remote = below(50) == 0;
    frame.extended = below(50) == 0;
    canopen::store(frame.data.data(), random_());
    if (frame.id == 0x605) aim(frame);
    if (frame.id == 0) command(frame);
    return frame;
  }

 private:
  /// Makes an SDO request that names an existing object more often than not.
  void aim(Frame& frame) {
    if (below(3) == 0) return;
    const canopen::EntryDescription& row = test_table()[below(test_table().size())];
    static constexpr std::array<std::uint8_t, 8> kInitiate{0x40, 0x40, 0x23, 0x2B, 0x2F, 0x22, 0x21, 0x20};
    frame.data[0] = below(2) == 0 ? kInitiate[below(kInitiate.size())] : static_cast<std::uint8_t>(below(256));
    canopen::store(&frame.data[1], row.index);
    frame.data[3] = row.sub_index;
    // Often a likely value: a COB-ID, valid or not, a mappable object, a small number.
    switch (below(5)) {
      case 0:
        canopen::store(&frame.data[4], static_cast<std::uint32_t>(0x180 + below(0x500)));
        break;
      case 1:
        frame.data[7] |= 0x80;
        break;
      case 2: {
        const canopen::EntryDescription& mapped = test_table()[below(test_table().size())];
        canopen::store(&frame.data[4], std::uint32_t{mapped.index} << 16 | std::uint32_t{mapped.sub_index} << 8 |
                                           8U * canopen::size_of(mapped.type));
        break;
      }
      case 3:
        canopen::store(&frame.data[4], static_cast<std::uint32_t>(below(6)));
        break;
      default:
        break;
    }
  }

  void command(Frame& frame) {
    if (below(3) == 0) return;
    static constexpr std::array<std::uint8_t, 8> kCommands{1, 1, 1, 1, 2, 128, 129, 130};
    frame.length = 2;
    frame.data[0] = kCommands[below(kCommands.size())];
    frame.data[1] = 5;
  }

  std::mt19937_64 random_;
};

std::uint64_t seed() {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 0) : std::random_device{}();
}

void expect_proper(std::span<const Frame> frames) {
  for (const Frame& frame : frames) {
    ASSERT_LE(frame.length, 8) << fakes::candump(frame);
    ASSERT_LE(frame.id, 0x7FFU) << fakes::candump(frame);
    ASSERT_FALSE(frame.remote || frame.extended) << fakes::candump(frame);
  }
}

TEST_F(Node, SurvivesFramesOfAnyContent) {
  const std::uint64_t seed_used = seed();
  SCOPED_TRACE("AXISD_TEST_SEED=" + std::to_string(seed_used));
  std::cout << "AXISD_TEST_SEED=" << seed_used << '\n';
  Noise noise{seed_used};
  start();

  for (int i = 0; i < 200'000; ++i) {
    const Frame frame = noise.frame(subscriptions());
    node->on_frame(frame, now);
    ASSERT_NO_FATAL_FAILURE(expect_proper(bus.take())) << "frame " << i << ": " << fakes::candump(frame);
    if (noise.below(4) == 0) node->on_values_changed(now);
    now += std::chrono::microseconds{noise.below(noise.below(1000) == 0 ? 11'000'000 : 500)};
    node->on_time(now);
    ASSERT_GT(node->next_deadline(), now);
    ASSERT_NO_FATAL_FAILURE(expect_proper(bus.take()));
    const auto listening = subscriptions();
    ASSERT_EQ(std::ranges::adjacent_find(listening, std::ranges::greater_equal{}), listening.end());
    ASSERT_TRUE(std::ranges::binary_search(listening, 0x605U));
  }
  says("000#8005");

  expect_dialogue({
      {"605#8000000000000000", ""},  // ends a block download, in which a request would pass for a segment
      {"605#4018100100000000", "585#431810012A000000"},
      {"605#4018100200000000", "585#4318100202000100"},
      {"605#4018100300000000", "585#4318100304000300"},
      {"605#4018100400000000", "585#4318100478563412"},
  });
}

}  // namespace
