#include "tests/libcanopen/fixture/pdo_table.hpp"

namespace {

using canopen::ErrorKeeping;
using canopen::Policy;
using canopen::Subscription;

constexpr std::uint32_t kStatusword = 0x60410010;

class TpdoRequests : public PdoTest {
 protected:
  using PdoTest::PdoTest;
  void SetUp() override { start(); }
  /// TPDO 5 of @p type carries the statusword and may be asked for.
  void map_requestable(std::uint8_t type) { map(0x1804, 0x00000455, type, {kStatusword}); }
};

TEST_F(TpdoRequests, AreAnsweredByEventDrivenTpdos) {
  for (const std::uint8_t type : {std::uint8_t{254}, std::uint8_t{255}}) {
    map_requestable(type);
    operate();
    EXPECT_EQ(says("455#R2"), (Lines{"455#4000"})) << +type;
    EXPECT_EQ(says("455#R"), (Lines{"455#4000"})) << "whatever length it asks for";
    says("000#8005");
  }
}

TEST_F(TpdoRequests, RespectTheInhibitTimeOfEventDrivenTpdos) {
  ASSERT_EQ(writes_u16(0x1804, 3, 100), 0U);  // 10 ms
  map_requestable(255);
  operate();

  EXPECT_EQ(says("455#R2"), Lines{});
  EXPECT_EQ(says("455#R2"), Lines{});
  EXPECT_EQ(passes(100ms), (Lines{"10ms 455#4000"}));
  EXPECT_EQ(says("455#R2"), (Lines{"455#4000"}));
}

TEST_F(TpdoRequests, AreAnsweredAtOnceByCyclicTpdosWithoutTouchingTheCycle) {
  map_requestable(2);
  operate();
  says("080#");
  store_value(0x6041, 0, 0x0237);

  EXPECT_EQ(says("455#R2"), (Lines{"455#3702"}));

  EXPECT_EQ(says("080#").back(), "455#3702");
}

TEST_F(TpdoRequests, AreAnsweredAtOnceByTpdosThatWaitForAChange) {
  map_requestable(0);
  operate();
  EXPECT_EQ(says("080#").back(), "455#4000");
  store_value(0x6041, 0, 0x0237);

  EXPECT_EQ(says("455#R2"), (Lines{"455#3702"}));
}

TEST_F(TpdoRequests, ShowTheValuesOfTheLastSyncInType252) {
  map_requestable(252);
  operate();
  EXPECT_EQ(says("455#R2"), (Lines{"455#4000"})) << "before the first SYNC: as they are";
  store_value(0x6041, 0, 1);
  EXPECT_EQ(says("455#R2"), (Lines{"455#0100"}));

  store_value(0x6041, 0, 2);
  const Lines with_sync = says("080#");
  EXPECT_EQ(std::ranges::count(with_sync, "455#0200"), 0) << "nobody has asked";
  store_value(0x6041, 0, 3);

  EXPECT_EQ(says("455#R2"), (Lines{"455#0200"}));
  EXPECT_EQ(says("455#R2"), (Lines{"455#0200"}));
  says("080#");
  EXPECT_EQ(says("455#R2"), (Lines{"455#0300"}));

  store_value(0x6041, 0, 4);
  says("000#8005");
  operate();
  EXPECT_EQ(says("455#R2"), (Lines{"455#0400"})) << "no SYNC since Operational was entered";
}

TEST_F(TpdoRequests, ShowThePresentValuesInType253) {
  map_requestable(253);
  operate();
  store_value(0x6041, 0, 1);
  says("080#");
  EXPECT_EQ(sets(0x6041, 2), (Lines{"185#0200"})) << "TPDO 1 alone: a change is no request";

  EXPECT_EQ(says("455#R2"), (Lines{"455#0200"}));
}

TEST_F(TpdoRequests, StayUnansweredIfTheCobIdForbidsThem) {
  map(0x1804, 0x40000455, 253, {kStatusword});
  operate();
  EXPECT_EQ(says("455#R2"), Lines{});
  EXPECT_EQ(says("185#R2"), Lines{}) << "TPDO 1 likewise";
}

TEST_F(TpdoRequests, MayBeAllowedAndForbiddenWhileTheTpdoIsValid) {
  const auto wants_requests = [&] {
    return std::ranges::count(node->subscriptions(), Subscription{.identifier = 0x455, .remote = true});
  };
  map_requestable(253);
  operate();
  EXPECT_EQ(wants_requests(), 1);

  ASSERT_EQ(writes_u32(0x1804, 1, 0x40000455), 0U);
  EXPECT_EQ(wants_requests(), 0);
  EXPECT_EQ(says("455#R2"), Lines{});

  ASSERT_EQ(writes_u32(0x1804, 1, 0x00000455), 0U);
  EXPECT_EQ(wants_requests(), 1);
  EXPECT_EQ(says("455#R2"), (Lines{"455#4000"}));
}

TEST_F(TpdoRequests, StayUnansweredOutsideOperationalAndWithoutMapping) {
  map_requestable(253);
  EXPECT_EQ(says("455#R2"), Lines{});
  says("000#0205");
  EXPECT_EQ(says("455#R2"), Lines{});
  says("000#8005");
  map(0x1804, 0x00000455, 253, {});
  operate();
  EXPECT_EQ(says("455#R2"), Lines{});
}

TEST_F(TpdoRequests, DoNotReachRpdos) {
  ASSERT_EQ(writes_u32(0x1400, 1, 0x80000205), 0U);
  ASSERT_EQ(writes_u32(0x1400, 1, 0x40000205), 0U);  // bit 30 has no meaning there
  EXPECT_EQ(value_of(0x1400, 1), 0x40000205);
  operate();

  EXPECT_EQ(says("205#R2"), Lines{});
  says("205#0F00");

  EXPECT_EQ(value_of(0x6040), 0x0F);
}

TEST_F(TpdoRequests, WorkWithIdentifiersOf29Bits) {
  map(0x1804, 0x20012345, 253, {kStatusword});
  operate();

  EXPECT_EQ(says("00012345#R2"), (Lines{"00012345#4000"}));
  EXPECT_EQ(says("345#R2"), Lines{});
}

TEST_F(TpdoRequests, FindTpdosAndRpdosOf29BitsBesideThoseOf11) {
  map(0x1404, 0x20000205, 255, {0x60600008});
  map(0x1804, 0x60000185, 1, {kStatusword});
  operate();

  says("00000205#03");
  EXPECT_EQ(value_of(0x6060), 3);
  EXPECT_EQ(value_of(0x6040), 1) << "of 205h with 11 bits";
  EXPECT_EQ(says("080#").back(), "00000185#4000");
}

class TpdosWithoutRequests : public TpdoRequests {
 protected:
  TpdosWithoutRequests() : TpdoRequests{Policy{.error_keeping = ErrorKeeping::Owner, .tpdo_requests = false}} {}
};

TEST_F(TpdosWithoutRequests, StaySilentWhateverTheCobIdSays) {
  map_requestable(255);
  operate();

  EXPECT_EQ(says("455#R2"), Lines{});
  EXPECT_EQ(value_of(0x1804, 1), 0x455);
}

}  // namespace
