#include "tests/injection/faulty_unit.hpp"

namespace injection {
namespace {

const Lines kNone{};

/// Node 5 in Operational, at rest; the master changes the controlword and the four TPDOs come.
class PdoFaults : public testing::Test {
 protected:
  PdoFaults() { unit.start_operational(); }
  FaultyUnit unit;
};

TEST_F(PdoFaults, SwallowDelayAndDoubleATpdo) {
  unit.inject("tpdo.swallow pdo=1 times=1");
  unit.inject("tpdo.late pdo=2 delay_ms=10 times=1");
  unit.inject("tpdo.twice pdo=3 times=1");
  EXPECT_EQ(unit.turns("205#0600"), (Lines{"385#31160000", "385#31160000", "485#311600000000"}));
  EXPECT_EQ(unit.passes(10ms), Lines{"285#311600000000"});
  EXPECT_EQ(unit.turns("205#0700").size(), 4U);
}

TEST_F(PdoFaults, ShortenATpdo) {
  unit.inject("tpdo.short pdo=2");
  unit.inject("tpdo.short pdo=3 length=1");
  EXPECT_EQ(unit.turns("205#0600"), (Lines{"185#3116", "285#3116000000", "385#31", "485#311600000000"}));
}

TEST_F(PdoFaults, FreezeATpdo) {
  unit.inject("tpdo.frozen pdo=1 times=2");
  EXPECT_EQ(unit.turns("205#0600")[0], "185#3116");
  EXPECT_EQ(unit.turns("205#0700")[0], "185#3116");
  EXPECT_EQ(unit.turns("205#0600")[0], "185#3116");  // this is the truth again
}

TEST_F(PdoFaults, FreezeEachTpdoAtItsOwnValues) {
  unit.inject("tpdo.frozen");
  const Lines first = unit.turns("205#0600");
  ASSERT_EQ(first.size(), 4U);
  EXPECT_EQ(unit.turns("205#0700"), first);
}

TEST_F(PdoFaults, NeverMakeATpdoLonger) {
  unit.inject("tpdo.short pdo=1 length=8");
  EXPECT_EQ(unit.turns("205#0600")[0], "185#3116");
}

TEST(PdoNumbers, OfEveryAxisBeginAnew) {
  device::Configuration configuration = device::unit_with({});
  configuration.axes.push_back(configuration.axes[0]);
  FaultyUnit unit{configuration};
  unit.start();
  unit.inject("tpdo.swallow pdo=65");
  EXPECT_FALSE(unit.faults.add(fault_of("tpdo.swallow pdo=64")));
}

TEST_F(PdoFaults, ExchangeMappedValues) {
  unit.inject("tpdo.swap pdo=2");
  EXPECT_EQ(unit.turns("205#0600")[1], "285#000000003116");
}

TEST_F(PdoFaults, AreDeafToAnRpdo) {
  unit.inject("rpdo.deaf pdo=1 times=1");
  EXPECT_EQ(unit.turns("205#0600"), kNone);
  EXPECT_EQ(unit.number_at(0x6040), 0);
  EXPECT_EQ(unit.turns("205#0600").size(), 4U);
}

TEST(SyncFaults, AreDeafToSync) {
  FaultyUnit unit;
  unit.start();
  unit.says("605#2F00180201000000");  // TPDO 1 with every SYNC
  unit.says("000#0105");
  unit.passes(8ms);
  EXPECT_EQ(unit.says("080#"), Lines{"185#4016"});
  unit.inject("sync.deaf every=2");
  EXPECT_EQ(unit.says("080#"), Lines{"185#4016"});
  EXPECT_EQ(unit.says("080#"), kNone);
}

TEST_F(PdoFaults, OfAPdoThatIsNotThereAreRefused) {
  const auto id = unit.faults.add(fault_of("tpdo.swallow pdo=300"));
  ASSERT_FALSE(id);
  EXPECT_EQ(id.error(), "pdo: expected 1 to 8, the PDOs of the unit, got 300");
}

TEST_F(PdoFaults, CountAndAreTakenBack) {
  const auto id = unit.inject("tpdo.swallow pdo=1");
  unit.turns("205#0600");
  ASSERT_EQ(unit.faults.loaded().size(), 1U);
  EXPECT_EQ(unit.faults.loaded()[0].trigger.hits(), 1U);
  EXPECT_TRUE(unit.faults.remove(id));
  EXPECT_FALSE(unit.faults.remove(id));
  EXPECT_EQ(unit.turns("205#0700")[0], "185#3316");
}

TEST_F(PdoFaults, LoseNothingThatIsDelayedWhenTheyAreTakenBack) {
  unit.inject("tpdo.late delay_ms=1000");
  EXPECT_EQ(unit.turns("205#0600"), kNone);
  unit.faults.remove_all();
  EXPECT_EQ(unit.passes(0ms).size(), 4U);
}

TEST_F(PdoFaults, HoldInOneStateOnly) {
  unit.inject("tpdo.swallow while=switched-on");
  EXPECT_EQ(unit.turns("205#0600").size(), 4U);
  EXPECT_EQ(unit.turns("205#0700"), kNone);
}

TEST_F(PdoFaults, OfOneSeedHitTheSameTwice) {
  std::vector<std::uint64_t> first;
  for (int run = 0; run < 2; ++run) {
    FaultyUnit other;
    other.start_operational();
    other.inject("tpdo.swallow probability=0.4 seed=11");
    for (int i = 0; i < 20; ++i) other.turns(i % 2 == 0 ? "205#0600" : "205#0700");
    const auto hit = other.faults.loaded()[0].trigger.hit_at();
    EXPECT_EQ(hit.size(), Trigger::kKept);
    if (run == 0)
      first.assign(hit.begin(), hit.end());
    else
      EXPECT_TRUE(std::ranges::equal(first, hit));
  }
}

TEST_F(PdoFaults, AreNoMoreThanThereIsRoomFor) {
  for (std::size_t i = 0; i < UnitFaults::kMost; ++i) unit.inject("tpdo.swallow after=1000");
  const auto id = unit.faults.add(fault_of("tpdo.swallow"));
  ASSERT_FALSE(id);
  EXPECT_EQ(id.error(), "64 faults are loaded, that is the most: take some back");
}

}  // namespace
}  // namespace injection
