// The infeed as a drive object: its sequence control, the DC link, and what is said of it.
#include "drive/infeed/infeed.hpp"

#include <array>

#include "drive/explain/explain.hpp"
#include "tests/drive/test_drive_unit.hpp"

namespace drive {
namespace {

constexpr std::uint8_t kFeed = kInfeedNumber;
constexpr std::uint8_t kFirst = 3;

/// A unit of one axis behind an infeed, whose inputs are constants.
struct FedUnit {
  DriveUnit unit{{.axes = {{}}, .node_id = 5, .infeed = true}};

  double read(std::uint8_t object, std::uint16_t number) const {
    return unit.object(object)->read(number).value();
  }
  void set(std::uint16_t number, double value, std::uint8_t object = kFeed) {
    ASSERT_TRUE(unit.object(object)->write(number, value)) << "p" << number;
  }
  void cycles(int count = 3) {
    constexpr std::array kAwake{true};
    for (int i = 0; i < count; ++i) unit.cycle(kAwake, kCycle);
  }
  void switch_on() {
    cycles();
    set(840, 1.0);
    cycles();
    ASSERT_EQ(display(), 0.0);
  }
  double display() const { return read(kFeed, 2); }
  std::string told() const {
    std::string all;
    for (const std::string& sentence : explain(*unit.infeed())) all += sentence + '\n';
    return all;
  }
};

TEST(Infeed, LeavesFaultWithACauseThatWasAcknowledgedBefore) {
  FedUnit fed;
  fed.cycles();
  ASSERT_TRUE(fed.unit.infeed()->raise(8700, 1, Cause::Ending));
  ASSERT_EQ(fed.unit.infeed()->state(), State::Fault);
  EXPECT_FALSE(fed.unit.infeed()->acknowledge());
  ASSERT_EQ(fed.unit.infeed()->state(), State::Fault);

  fed.unit.infeed()->withdraw(8700);
  EXPECT_NE(fed.unit.infeed()->state(), State::Fault);
}

TEST(Infeed, IsReadyWithAnEmptyDcLink) {
  FedUnit fed;
  EXPECT_EQ(fed.display(), 70.0);
  fed.cycles(1);
  EXPECT_EQ(fed.display(), 41.0) << "Switch on disabled is seen for a cycle";
  fed.cycles(2);
  EXPECT_EQ(fed.display(), 31.0);
  EXPECT_EQ(fed.read(kFeed, 70), 0.0);
  EXPECT_EQ(fed.read(kFeed, 863), 0.0);
  EXPECT_EQ(fed.told(),
            "The infeed (drive object 2) is off, its ON is missing (p0840 = 0): write p0840 = 1 or connect it.\n");
}

TEST(Infeed, PutsTheDcLinkOnTheLine) {
  FedUnit fed;
  fed.switch_on();
  EXPECT_NEAR(fed.unit.dc_link().voltage(), 540.0, 1.0);
  EXPECT_EQ(fed.read(kFeed, 863), 3.0);
  EXPECT_EQ(fed.read(kFeed, 899), 0x1A17);
  EXPECT_EQ(fed.told(), "");
  EXPECT_TRUE(fed.unit.infeed()->is_quiescent());
  fed.set(840, 0.0);
  fed.cycles(1);
  EXPECT_EQ(fed.read(kFeed, 863), 0.0);
  EXPECT_EQ(fed.display(), 31.0);
}

TEST(Infeed, KeepsItsOffUntilOnIsGivenAnew) {
  FedUnit fed;
  fed.switch_on();
  fed.set(845, 0.0);
  fed.cycles();
  EXPECT_EQ(fed.display(), 42.0);
  EXPECT_EQ(fed.told(),
            "OFF2 of the infeed is given by p0845 = 0: write p0845 = 1 or connect it.\n"
            "ON of the infeed (p0840 = 1) is still set and needs an edge: write p0840 = 0 or connect it, then the "
            "contrary.\n");
  fed.set(845, 1.0);
  fed.cycles();
  EXPECT_EQ(fed.display(), 41.0);
  fed.set(840, 0.0);
  fed.cycles();
  fed.set(840, 1.0);
  fed.cycles();
  EXPECT_EQ(fed.display(), 0.0);
}

TEST(Infeed, OperatesOnlyWithItsEnable) {
  FedUnit fed;
  fed.set(852, 0.0);
  fed.cycles();
  fed.set(840, 1.0);
  fed.cycles();
  EXPECT_EQ(fed.display(), 21.0);
  EXPECT_EQ(fed.read(kFeed, 863), 2.0);
  EXPECT_EQ(fed.told(),
            "The operation enable of the infeed is missing (p0852 = 0): write p0852 = 1 or connect it.\n");
  fed.set(852, 1.0);
  fed.cycles();
  EXPECT_EQ(fed.display(), 0.0);
}

TEST(Infeed, IsKeptOffByCommissioningOfTheUnit) {
  FedUnit fed;
  fed.switch_on();
  fed.set(9, 1.0, kUnit);
  fed.cycles();
  EXPECT_EQ(fed.display(), 46.0);
}

TEST(Infeed, HasTheMessagesThatConcernIt) {
  FedUnit fed;
  fed.switch_on();
  for (const std::uint16_t number : std::initializer_list<std::uint16_t>{7900, 7011, 30001, 1000})
    EXPECT_FALSE(fed.unit.raise(kFeed, number)) << number;
  fed.set(2106, 0.0);
  fed.cycles();
  EXPECT_EQ(fed.read(kFeed, 945), 7860.0);
  EXPECT_EQ(fed.display(), 45.0);
  EXPECT_EQ(fed.told(),
            "The infeed has fault F07860 External fault 1 (value 0): remove its cause, acknowledge it (p2103 to "
            "p2105 or "
            "p3981 of drive object 2), then give ON anew.\n");
  fed.set(2104, 1.0);
  fed.cycles();
  EXPECT_EQ(fed.display(), 45.0) << "the cause is still there";
  fed.set(2104, 0.0);
  fed.set(2106, 1.0);
  fed.cycles();
  fed.set(2104, 1.0);
  fed.cycles();
  EXPECT_EQ(fed.display(), 41.0);
}

TEST(Infeed, LosesAFaultWhoseReactionIsNone) {
  FedUnit fed;
  fed.switch_on();
  fed.set(2100, 7860);
  fed.set(2101, 0);
  ASSERT_TRUE(fed.unit.raise(kFeed, 7860));
  fed.cycles();
  EXPECT_EQ(fed.display(), 0.0);
}

TEST(Infeed, AloneIsWhatTheAxisWaitsFor) {
  FedUnit fed;
  fed.cycles();
  for (const std::uint16_t number : std::initializer_list<std::uint16_t>{844, 848, 852})
    fed.set(number, 1.0, kFirst);
  fed.set(840, 0.0, kFirst);
  fed.cycles();
  fed.set(840, 1.0, kFirst);
  fed.cycles();
  EXPECT_EQ(fed.read(kFirst, 2), 23.0) << "without DC link voltage, whatever p0864 says";
  fed.set(840, 1.0);
  fed.cycles(5);
  EXPECT_EQ(fed.read(kFirst, 2), 0.0);
}

}  // namespace
}  // namespace drive
