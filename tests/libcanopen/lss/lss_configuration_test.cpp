#include "tests/libcanopen/fixture/lss_fixture.hpp"

namespace {

using canopen::kNoNodeId;
using canopen::LssStored;
using canopen::NmtState;

std::string byte(unsigned value) {
  char text[3];
  std::snprintf(text, sizeof text, "%02X", value);
  return text;
}

/// A slave in its configuration state.
class LssConfiguration : public LssTest {
 protected:
  void SetUp() override {
    start();
    select();
  }
};

TEST_F(LssConfiguration, TellsTheIdentity) {
  EXPECT_EQ(asks("5A"), answer("5A2A"));
  EXPECT_EQ(asks("5B"), answer("5B02000100"));
  EXPECT_EQ(asks("5C"), answer("5C04000300"));
  EXPECT_EQ(asks("5D"), answer("5D78563412"));
}

TEST_F(LssConfiguration, TellsTheNodeIdInForce) {
  EXPECT_EQ(asks("5E"), answer("5E05"));
  EXPECT_EQ(asks("1109"), answer("11"));
  EXPECT_EQ(asks("5E"), answer("5E05")) << "9 is pending";
}

TEST_F(LssConfiguration, TakesEveryNodeIdThatThereIs) {
  for (unsigned id = 0; id <= 0xFF; ++id) {
    const bool exists = (id >= 1 && id <= 127) || id == 255;
    const std::uint8_t before = lss.settings().node_id;
    EXPECT_EQ(asks("11" + byte(id)), answer(exists ? "1100" : "1101")) << id;
    EXPECT_EQ(lss.settings().node_id, exists ? id : before) << id;
  }
}

TEST_F(LssConfiguration, TakesEveryBitRateOfTheTable) {
  constexpr std::array<std::uint16_t, 9> kRates{1000, 800, 500, 250, 125, 0, 50, 20, 10};
  for (unsigned index = 0; index <= 0xFF; ++index) {
    const bool exists = index < kRates.size() && kRates[index] != 0;
    const std::uint16_t before = lss.settings().bit_rate;
    EXPECT_EQ(asks("1300" + byte(index)), answer(exists ? "1300" : "1301")) << index;
    EXPECT_EQ(lss.settings().bit_rate, exists ? kRates[index] : before) << index;
  }
}

TEST_F(LssConfiguration, KnowsNoOtherTable) {
  for (unsigned table = 1; table <= 0xFF; ++table)
    EXPECT_EQ(asks("13" + byte(table) + "02"), answer("1301")) << table;
  EXPECT_EQ(lss.settings().bit_rate, 0);
}

TEST_F(LssConfiguration, TellsTheDeviceWhenTheBitRateIsSwitched) {
  EXPECT_EQ(asks("156400"), Lines{});
  EXPECT_EQ(told(), (Lines{"activate 0 after 100 ms"}));
  asks("130003");
  EXPECT_EQ(asks("15FFFF"), Lines{});
  EXPECT_EQ(told(), (Lines{"activate 250 after 65535 ms"}));
  EXPECT_EQ(asks("5E"), answer("5E05")) << "answers go on";
}

TEST_F(LssConfiguration, AnswersAStoreAsTheDeviceSays) {
  struct Row {
    LssStored outcome;
    const char* answer;
  };
  for (const Row& row :
       {Row{LssStored::Done, "1700"}, Row{LssStored::NotSupported, "1701"}, Row{LssStored::Failed, "1702"}}) {
    device.outcome = row.outcome;
    EXPECT_EQ(asks("17"), answer(row.answer));
    EXPECT_EQ(told(), (Lines{"store 5, 0"}));
  }
}

TEST_F(LssConfiguration, StoresWhatIsPending) {
  asks("1109");
  asks("130004");
  EXPECT_EQ(asks("17"), answer("17"));
  asks("11FF");
  EXPECT_EQ(asks("17"), answer("17"));
  EXPECT_EQ(told(), (Lines{"store 9, 125", "store 255, 125"}));
}

TEST_F(LssConfiguration, KeepsThePendingBitRateThroughAReset) {
  asks("130004");
  says("000#8105");
  select();
  asks("17");
  EXPECT_EQ(told(), (Lines{"store 5, 125"}));
}

TEST_F(LssConfiguration, AnswersAStoreLaterIfTheDeviceWantsThat) {
  device.outcome = LssStored::Later;
  EXPECT_EQ(asks("17"), Lines{});
  EXPECT_EQ(asks("17"), Lines{}) << "the master has lost its patience";
  EXPECT_EQ(told(), (Lines{"store 5, 0"})) << "once";

  lss.answer_store(LssStored::Failed);
  EXPECT_EQ(sent(), answer("1702"));
  lss.answer_store(LssStored::Done);
  EXPECT_EQ(sent(), Lines{}) << "nobody waits";
  EXPECT_EQ(asks("17"), Lines{});
  EXPECT_EQ(told(), (Lines{"store 5, 0"}));
}

TEST_F(LssConfiguration, GivesALateAnswerUpWhenTheMasterGoesOn) {
  device.outcome = LssStored::Later;
  for (const char* const request : {"5E", "0400", "4C", "00"}) {
    asks("0401");
    asks("17");
    asks(request);
    lss.answer_store(LssStored::Done);
    EXPECT_EQ(sent(), Lines{}) << request;
  }
  asks("0401");
  asks("17");
  says("000#8205");
  lss.answer_store(LssStored::Done);
  EXPECT_EQ(sent(), Lines{});
}

TEST_F(LssConfiguration, BringsTheNodeIdIntoForceWithAReset) {
  asks("1109");
  asks("0400");
  EXPECT_EQ(says("605#4000100000000000"), (Lines{"585#4300100092010200"})) << "not yet";

  EXPECT_EQ(says("000#8205"), (Lines{"709#00"}));
  EXPECT_EQ(says("605#4000100000000000"), Lines{});
  EXPECT_EQ(says("609#4000100000000000"), (Lines{"589#4300100092010200"}));

  select();
  EXPECT_EQ(asks("5E"), answer("5E09"));
  asks("110A");
  EXPECT_EQ(says("000#8109"), (Lines{"70A#00"})) << "reset node does too, whatever the LSS state";
}

TEST_F(LssConfiguration, TakesTheNodeIdAwayWithAReset) {
  says("000#0105");
  EXPECT_EQ(asks("11FF"), answer("11"));
  asks("0400");
  EXPECT_EQ(node->state(), NmtState::Operational);
  EXPECT_EQ(asks("4C"), Lines{}) << "it still has its node-ID";

  EXPECT_EQ(says("000#8205"), Lines{});
  EXPECT_EQ(node->state(), NmtState::Unconfigured);
  EXPECT_EQ(asks("4C"), answer("50"));
}

TEST_F(LssConfiguration, BootsNothingThatHasANodeId) {
  asks("1109");
  application.told.clear();
  EXPECT_EQ(asks("0400"), Lines{});
  EXPECT_EQ(application.told, Lines{});
}

/// A device that leaves LSS to itself.
class LssOfASimpleDevice : public NodeTest {
 protected:
  canopen::LssApplication device;
  canopen::LssSlave lss{node->context(), device};
};

TEST_F(LssOfASimpleDevice, StoresNothing) {
  start();
  says("7E5#0401000000000000");
  EXPECT_EQ(says("7E5#1700000000000000"), (Lines{"7E4#1701000000000000"}));
  EXPECT_EQ(says("7E5#1564000000000000"), Lines{});
}

}  // namespace
