#include "tests/libcanopen/fixture/pdo_table.hpp"

namespace {

/// An application that answers what it is told with an error of its own class, from within the call.
class Reactions : public PdoTest {
 protected:
  void SetUp() override { start_operational(); }
  /// Applies the error behaviour as soon as the application is told @p what.
  void leave_operational_on(const std::string& what) {
    application.reaction = [=, this](const std::string& told) {
      if (told == what) node->apply_error_behaviour(2);
    };
  }
  /// An RPDO of @p type that puts 16 bits into 2014h.
  void map_rpdo_5(std::uint8_t type) { map(0x1404, 0x00000505, type, {0x20140010}); }
};

TEST_F(Reactions, ToOperationalItselfSendNoTpdo) {
  says("000#8005");
  application.told.clear();
  leave_operational_on("Pre-operational -> Operational");

  EXPECT_EQ(says("000#0105"), Lines{});

  EXPECT_EQ(application.told, (Lines{"Pre-operational -> Operational", "Operational -> Pre-operational"}));
  EXPECT_EQ(sets(0x6041, 7), Lines{}) << "TPDOs belong to Operational";
}

TEST_F(Reactions, ToASynchronousRpdoLeaveThoseBehindItAlone) {
  map_rpdo_5(1);
  says("405#0F0078563412");
  says("505#3412");
  application.told.clear();
  leave_operational_on("RPDO 2");

  says("080#");

  EXPECT_EQ(application.told, (Lines{"RPDO 2", "Operational -> Pre-operational"}));
  EXPECT_EQ(value_of(0x2014), 0);

  application.reaction = nullptr;
  operate();
  says("080#");
  EXPECT_EQ(value_of(0x2014), 0) << "what waited is forgotten";
}

TEST_F(Reactions, ToAFrameThatIsTooLongEndItsProcessing) {
  ASSERT_EQ(writes_u16(0x1400, 5, 20), 0U);
  leave_operational_on("8220 1");

  says("205#0F00FF");

  EXPECT_EQ(node->state(), canopen::NmtState::PreOperational);
  EXPECT_EQ(value_of(0x6040), 1) << "as before";
  EXPECT_EQ(node->next_deadline(), canopen::kNever) << "no deadline is watched outside Operational";
}

TEST_F(Reactions, ToTheEndOfAMissedDeadlineEndTheProcessingOfItsFrame) {
  ASSERT_EQ(writes_u16(0x1402, 5, 20), 0U);
  says("405#0F0078563412");
  passes(20ms);
  leave_operational_on("8250 3 over");

  says("405#1F0078563412");

  EXPECT_EQ(node->next_deadline(), canopen::kNever);
  application.reaction = nullptr;
  operate();
  says("080#");
  EXPECT_EQ(value_of(0x6040), 1) << "neither the forgotten frame nor the one that came too late";
}

class ReactionsKeptByTheLibrary : public PdoTest {
 protected:
  ReactionsKeptByTheLibrary() : PdoTest{canopen::Policy{}} {}
};

TEST_F(ReactionsKeptByTheLibrary, RaiseErrorsOfTheApplication) {
  start_operational();
  application.reaction = [this](const std::string& told) {
    if (told == "RPDO 0") node->raise_error(0xFF01, 0x1234, 0x80);
  };

  EXPECT_EQ(says("205#0F00"), (Lines{"085#01FF813412000000"}));
}

}  // namespace
