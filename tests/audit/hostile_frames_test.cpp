#include <array>
#include <cstdlib>
#include <iostream>
#include <random>

#include <gtest/gtest.h>

#include "audit/auditor.hpp"
#include "audit/catalogue.hpp"

namespace audit_test {
namespace {

constexpr std::uint64_t kFrames = 2'000'000;

std::uint64_t seed() {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
}

/// Makes frames that nobody would send: at random, and such that look like services.
class HostileBus {
 public:
  explicit HostileBus(std::uint64_t seed) : random_{seed} {}

  audit::Heard next() {
    at_ += std::chrono::microseconds{below(1000)};
    audit::Heard heard{.frame = frame(), .at = at_, .place = ++place_};
    heard.is_error = below(1000) == 0;
    return heard;
  }

 private:
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

  canopen::Frame frame() {
    switch (below(8)) {
      case 0:
        return anything(below(0x800));
      case 1:
        return of_a_service();
      case 2:
        return answer();
      default:
        return request();
    }
  }

  canopen::Frame anything(std::uint32_t identifier) {
    canopen::Frame frame{.id = identifier, .length = static_cast<std::uint8_t>(below(9))};
    frame.extended = below(100) == 0;
    frame.remote = below(20) == 0;
    for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random_());
    return frame;
  }

  canopen::Frame of_a_service() {
    constexpr std::array<std::uint32_t, 8> kFunctions{0x080, 0x180, 0x200, 0x280, 0x300, 0x700, 0x7E4, 0x7E5};
    const std::uint32_t function = kFunctions[below(kFunctions.size())];
    canopen::Frame frame = anything(function < 0x7E0 ? function + below(128) : function);
    if (below(10) == 0) frame = canopen::Frame{.id = 0, .length = 2};
    if (frame.id == 0)
      frame.data = {static_cast<std::uint8_t>(128 + below(4)), static_cast<std::uint8_t>(below(128))};
    if (frame.id > 0x700) frame.data[0] &= 0x7F;
    return frame;
  }

  canopen::Frame request() {
    constexpr std::array<std::uint8_t, 8> kCommands{0x23, 0x2F, 0x2B, 0x40, 0x21, 0x60, 0xC2, 0xA0};
    canopen::Frame frame{.id = 0x600 + below(128), .length = 8};
    frame.data[0] = below(4) == 0 ? static_cast<std::uint8_t>(random_()) : kCommands[below(kCommands.size())];
    const std::uint32_t index = below(200) == 0 ? 0x1000 + below(0x1000) : 0x2000 + below(0x8000);
    frame.data[1] = static_cast<std::uint8_t>(index);
    frame.data[2] = static_cast<std::uint8_t>(index >> 8);
    for (std::size_t i = 3; i < frame.data.size(); ++i) frame.data[i] = static_cast<std::uint8_t>(random_());
    waiting_ = frame;
    return frame;
  }

  /// What the server of the last request might say.
  canopen::Frame answer() {
    constexpr std::array<std::uint8_t, 8> kCommands{0x60, 0x43, 0x4F, 0x80, 0x41, 0x20, 0xA4, 0xC2};
    canopen::Frame frame = waiting_;
    frame.id = 0x580 + waiting_.id % 128;
    frame.data[0] = kCommands[below(kCommands.size())];
    return frame;
  }

  std::mt19937_64 random_;
  canopen::Duration at_{};
  std::uint64_t place_ = 0;
  canopen::Frame waiting_{.id = 0x605, .length = 8};
};

class HostileFrames : public testing::Test {
 protected:
  HostileFrames() {
    const std::uint64_t chosen = seed();
    std::cout << "AXISD_TEST_SEED=" << chosen << std::endl;
    HostileBus bus{chosen};
    for (std::uint64_t i = 0; i < kFrames; ++i) auditor_.take(bus.next());
    auditor_.end();
  }

  audit::Auditor auditor_{{.bit_rate = 125'000}};
};

TEST_F(HostileFrames, LeaveTheMemoryBounded) {
  std::size_t rules = 0;
  for (const audit::RuleGroup& group : audit::rule_groups()) rules += group.rules.size();
  const audit::Findings& findings = auditor_.findings();
  EXPECT_GT(findings.total(), kFrames / 10);
  EXPECT_LE(findings.kept().size(), rules * audit::Network::kNodes * audit::Findings::kMostKept);
  for (const audit::Finding& finding : findings.kept()) {
    EXPECT_LE(findings.count(*finding.rule, finding.node), findings.total());
    EXPECT_LE(finding.evidence.size(), 3u);
  }
  for (const audit::Node& node : auditor_.network().nodes())
    EXPECT_LE(node.values.size(), audit::KnownValues::kMostValues) << int{node.id};
  for (const audit::TimeLine& line : auditor_.time_lines()) {
    EXPECT_LE(line.first().size(), audit::TimeLine::kMostKept);
    EXPECT_LE(line.last().size(), audit::TimeLine::kMostKept);
  }
}

}  // namespace
}  // namespace audit_test
