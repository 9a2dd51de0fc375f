#include <cstdlib>
#include <iostream>
#include <random>
#include <set>

#include "tests/libcanopen/fixture/lss_bus.hpp"
#include "tests/libcanopen/fixture/lss_fixture.hpp"

namespace {

using canopen::Frame;
using canopen::kNoNodeId;
using canopen::LssState;
using canopen::NmtState;
using Frames = LssBus::Frames;

constexpr LssIdentity kIdentity{0, 0x402, 0x10000, 1};

/// Finds all nodes on @p bus and gives them node-IDs from 1 on; their identities in the order of being found.
std::vector<LssIdentity> configure_all(LssBus& bus) {
  std::vector<LssIdentity> found;
  while (const auto identity = bus.finds()) {
    found.push_back(*identity);
    const auto node_id = static_cast<std::uint8_t>(found.size());
    EXPECT_EQ(bus.configures(node_id), (Frames{{.id = 0x700U + node_id, .length = 1}})) << "boots";
    if (found.size() > 100) break;
  }
  return found;
}

TEST(LssFastscan, FindsNobodyOnAnEmptyBus) {
  LssBus bus;
  EXPECT_EQ(bus.finds(), std::nullopt);
}

TEST(LssFastscan, FindsANodeInFourTimes33Requests) {
  LssBus bus;
  LssStation& station = bus.add(kIdentity);
  EXPECT_EQ(bus.finds(), kIdentity);
  EXPECT_EQ(bus.requests(), 1 + 4 * 33);
  EXPECT_EQ(station.lss.state(), LssState::Configuration);
}

TEST(LssFastscan, FindsEveryIdentity) {
  for (const std::uint32_t number : {0U, 1U, 0x80000000U, 0xFFFFFFFFU, 0x55555555U, 0xAAAAAAAAU, 0x12345678U}) {
    for (std::size_t position = 0; position < kIdentity.size(); ++position) {
      LssBus bus;
      LssIdentity identity = kIdentity;
      identity.at(position) = number;
      bus.add(identity);
      EXPECT_EQ(bus.finds(), identity) << std::hex << number;
    }
  }
}

TEST(LssFastscan, FindsTwoNodesWhoseSerialNumbersDifferInOneBit) {
  for (unsigned bit = 0; bit < 32; ++bit) {
    LssBus bus;
    LssIdentity other = kIdentity;
    other[3] ^= 1U << bit;
    LssStation& a = bus.add(kIdentity);
    LssStation& b = bus.add(other);

    const LssIdentity lower = std::min(kIdentity, other);
    const LssIdentity higher = std::max(kIdentity, other);
    EXPECT_EQ(configure_all(bus), (std::vector{lower, higher})) << "0 is tried first, bit " << bit;
    EXPECT_EQ(a.node.node_id(), a.identity == lower ? 1 : 2);
    EXPECT_EQ(b.node.node_id(), b.identity == lower ? 1 : 2);
    EXPECT_EQ(a.node.state(), NmtState::PreOperational);
    EXPECT_EQ(b.node.state(), NmtState::PreOperational);
  }
}

TEST(LssFastscan, FindsTwoNodesWhoseNumbersDifferInAllBits) {
  for (std::size_t position = 0; position < kIdentity.size(); ++position) {
    LssBus bus;
    LssIdentity other = kIdentity;
    other.at(position) = ~other.at(position);
    bus.add(other);
    bus.add(kIdentity);
    EXPECT_EQ(configure_all(bus), (std::vector{kIdentity, other})) << position;
  }
}

TEST(LssFastscan, FindsNodesThatDifferInEveryNumber) {
  LssBus bus;
  const LssIdentity a{0x12345678, 0xFFFFFFFF, 0, 0x80000001};
  const LssIdentity b{0x12345679, 0, 0xFFFFFFFF, 0x80000001};
  const LssIdentity c{~a[0], ~a[1], ~a[2], ~a[3]};
  for (const LssIdentity& identity : {c, a, b}) bus.add(identity);
  EXPECT_EQ(configure_all(bus), (std::vector{a, b, c}));
}

TEST(LssFastscan, FindsAllOfManyNodes) {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  const std::uint64_t seed = given != nullptr ? std::strtoull(given, nullptr, 0) : std::random_device{}();
  SCOPED_TRACE("AXISD_TEST_SEED=" + std::to_string(seed));
  std::cout << "AXISD_TEST_SEED=" << seed << '\n';
  std::mt19937_64 random{seed};
  LssBus bus;
  std::set<LssIdentity> identities;
  while (identities.size() < 40) {
    LssIdentity identity = kIdentity;
    identity.at(random() % 4) ^= static_cast<std::uint32_t>(random());
    identities.insert(identity);
  }
  for (const LssIdentity& identity : identities) bus.add(identity);

  EXPECT_EQ(configure_all(bus), (std::vector<LssIdentity>{identities.begin(), identities.end()}));
}

TEST(LssFastscan, PassesNodesByThatHaveANodeId) {
  LssBus bus;
  LssStation& configured = bus.add(kIdentity, 5);
  LssIdentity other = kIdentity;
  other[3] = 2;
  bus.add(other);

  EXPECT_EQ(bus.finds(), other);
  EXPECT_EQ(configured.lss.state(), LssState::Waiting);
  EXPECT_EQ(bus.configures(6), (Frames{{.id = 0x706, .length = 1}}));
  EXPECT_EQ(bus.finds(), std::nullopt);
  EXPECT_EQ(configured.node.node_id(), 5);
}

TEST(LssFastscan, FindsNodesAgainThatHaveLostTheirNodeId) {
  LssBus bus;
  LssStation& station = bus.add(kIdentity, 5);
  bus.asks(0x04, 1U);
  EXPECT_EQ(bus.configures(kNoNodeId), Frames{});
  EXPECT_EQ(bus.finds(), std::nullopt) << "it works on until the reset";

  bus.says({.id = 0, .length = 2, .data = {130, 0}});
  EXPECT_EQ(bus.finds(), kIdentity);
  EXPECT_EQ(bus.configures(9), (Frames{{.id = 0x709, .length = 1}}));
  EXPECT_EQ(station.node.node_id(), 9);
}

/// The requests themselves, to one node without a node-ID and with the identity 2Ah, 00010002h, 00030004h,
/// 12345678h.
class LssFastscanRequest : public LssTest {
 protected:
  LssFastscanRequest() { node->set_node_id(kNoNodeId); }
  void SetUp() override { start(); }
  bool scans(const char* number, const char* lowest_bit, const char* position, const char* next) {
    const Lines said = asks(std::string{"51"} + number + lowest_bit + position + next);
    if (!said.empty()) {
      EXPECT_EQ(said, answer("4F"));
    }
    return !said.empty();
  }
};

TEST_F(LssFastscanRequest, ForAnybodyIsAnsweredWhateverItsNumber) {
  EXPECT_TRUE(scans("00000000", "80", "00", "00"));
  EXPECT_TRUE(scans("FFFFFFFF", "80", "03", "FF"));
}

TEST_F(LssFastscanRequest, ComparesTheBitsFromTheLowestOneOn) {
  for (unsigned bit = 0; bit < 32; ++bit) {
    for (unsigned wrong = 0; wrong < 32; ++wrong) {
      char number[9], lowest[3];
      const std::uint32_t asked = 0x2A ^ 1U << wrong;
      std::snprintf(number, sizeof number, "%08X", __builtin_bswap32(asked));
      std::snprintf(lowest, sizeof lowest, "%02X", bit);
      EXPECT_EQ(scans(number, lowest, "00", "00"), wrong < bit) << wrong << ' ' << bit;
    }
  }
}

TEST_F(LssFastscanRequest, IsForOneNumberAtATime) {
  EXPECT_FALSE(scans("02000100", "00", "01", "01"));
  EXPECT_FALSE(scans("04000300", "00", "02", "02"));
  EXPECT_FALSE(scans("78563412", "00", "03", "03"));
  EXPECT_TRUE(scans("2A000000", "00", "00", "01"));
  EXPECT_FALSE(scans("2A000000", "00", "00", "01")) << "found already";
  EXPECT_TRUE(scans("02000100", "00", "01", "02"));
  EXPECT_TRUE(scans("04000300", "00", "02", "03"));
  EXPECT_TRUE(scans("78563412", "1F", "03", "00"));
  EXPECT_FALSE(is_selected()) << "not all bits";
  EXPECT_TRUE(scans("78563412", "00", "03", "00"));
  EXPECT_TRUE(is_selected());
}

TEST_F(LssFastscanRequest, ForAnybodyBeginsWithTheFirstNumberAgain) {
  EXPECT_TRUE(scans("2A000000", "00", "00", "01"));
  EXPECT_TRUE(scans("00000000", "80", "00", "00"));
  EXPECT_FALSE(scans("02000100", "00", "01", "02"));
  EXPECT_TRUE(scans("2A000000", "00", "00", "01"));
}

TEST_F(LssFastscanRequest, IsNotDisturbedByOtherServices) {
  EXPECT_TRUE(scans("2A000000", "00", "00", "01"));
  asks("4C");
  asks("402A");
  says("7E5#51");
  EXPECT_TRUE(scans("02000100", "00", "01", "02"));
}

TEST_F(LssFastscanRequest, LeavesTheOrderOfTheNumbersToTheMaster) {
  EXPECT_TRUE(scans("2A000000", "00", "00", "03"));
  EXPECT_TRUE(scans("78563412", "00", "03", "01"));
  EXPECT_TRUE(is_selected()) << "a step back ends it";
}

TEST_F(LssFastscanRequest, StaysAtANumberThatFollowsItself) {
  EXPECT_TRUE(scans("2A000000", "00", "00", "00"));
  EXPECT_TRUE(scans("2A000000", "00", "00", "00"));
  EXPECT_FALSE(is_selected());
}

TEST_F(LssFastscanRequest, IsIgnoredIfItMakesNoSense) {
  for (const char* const lowest : {"20", "7F", "81", "FF"}) EXPECT_FALSE(scans("2A000000", lowest, "00", "01"));
  for (const char* const position : {"04", "FF"}) EXPECT_FALSE(scans("2A000000", "00", position, "01"));
  for (const char* const next : {"04", "FF"}) EXPECT_FALSE(scans("2A000000", "00", "00", next));
  EXPECT_TRUE(scans("2A000000", "00", "00", "01"));
}

TEST_F(LssFastscanRequest, IsIgnoredByANodeInItsConfigurationState) {
  asks("0401");
  EXPECT_FALSE(scans("00000000", "80", "00", "00"));
  EXPECT_FALSE(scans("2A000000", "00", "00", "01"));
  asks("0400");
  EXPECT_TRUE(scans("2A000000", "00", "00", "01"));
}

TEST_F(LssFastscanRequest, IsIgnoredByANodeWhoseNodeIdIsPending) {
  node->set_node_id(9);
  EXPECT_FALSE(scans("00000000", "80", "00", "00"));
  EXPECT_EQ(asks("4C"), Lines{});
}

TEST_F(LssFastscanRequest, StartsOverAfterAReset) {
  EXPECT_TRUE(scans("2A000000", "00", "00", "01"));
  node->command(canopen::NmtCommand::ResetCommunication, now);
  EXPECT_TRUE(scans("2A000000", "00", "00", "01"));
}

TEST(LssNodes, AreToldApartByTheirSerialNumbers) {
  LssBus bus;
  LssIdentity other = kIdentity;
  other[3] = 2;
  LssStation& a = bus.add(kIdentity, 5);
  LssStation& b = bus.add(other, 6);

  for (std::uint8_t i = 0; i < 3; ++i)
    EXPECT_TRUE(bus.asks(static_cast<std::uint8_t>(0x40 + i), other.at(i)).empty());
  EXPECT_EQ(bus.asks(0x43, other[3]), (Frames{{.id = 0x7E4, .length = 8, .data = {0x44}}}));
  EXPECT_EQ(a.lss.state(), LssState::Waiting);
  EXPECT_EQ(b.lss.state(), LssState::Configuration);
  EXPECT_EQ(bus.asks(0x5E), (Frames{{.id = 0x7E4, .length = 8, .data = {0x5E, 6}}}));
}

TEST(LssNodes, AllAnswerWhoSeeksARange) {
  LssBus bus;
  for (const std::uint32_t serial : {3U, 4U, 5U, 6U}) {
    LssIdentity identity = kIdentity;
    identity[3] = serial;
    bus.add(identity, static_cast<std::uint8_t>(serial));
  }
  const std::uint32_t numbers[] = {kIdentity[0], kIdentity[1], kIdentity[2], kIdentity[2], 4, 5};
  Frames answers;
  for (std::uint8_t i = 0; i < std::size(numbers); ++i)
    answers = bus.asks(static_cast<std::uint8_t>(0x46 + i), numbers[i]);
  EXPECT_EQ(answers.size(), 2U);
  for (const Frame& answer : answers) EXPECT_EQ(answer, (Frame{.id = 0x7E4, .length = 8, .data = {0x4F}}));
}

}  // namespace
