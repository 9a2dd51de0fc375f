#include "tests/libcanopen/fixture/service_fixture.hpp"

namespace {

using canopen::CommunicationError;
using canopen::Policy;

constexpr const char* kReadRegister = "605#4001100000000000";
constexpr const char* kReadCount = "605#4003100000000000";

class ErrorKeeper : public ServiceTest {
 protected:
  using ServiceTest::ServiceTest;

  Lines raises(std::uint16_t code, std::uint16_t detail, std::uint8_t bits) {
    node->raise_error(code, detail, bits);
    return sent();
  }
  Lines clears(std::uint16_t code, std::uint16_t detail) {
    node->clear_error(code, detail);
    return sent();
  }
};

TEST_F(ErrorKeeper, ShowsThatThereIsNoError) {
  start();

  expect_dialogue({
      {kReadRegister, "585#4F01100000000000"},
      {kReadCount, "585#4F03100000000000"},
      {"605#4003100100000000", "585#8003100124000008"},  // no data
      {"605#4003100400000000", "585#8003100424000008"},
      {"605#4003100500000000", "585#8003100511000906"},  // no such entry
  });
}

TEST_F(ErrorKeeper, SendsShowsAndLogsAnError) {
  start();

  EXPECT_EQ(raises(0x3210, 0xABCD, 0x04), (Lines{"085#103205CDAB000000"}));

  expect_dialogue({
      {kReadRegister, "585#4F01100005000000"},
      {kReadCount, "585#4F03100001000000"},
      {"605#4003100100000000", "585#430310011032CDAB"},
      {"605#4003100200000000", "585#8003100224000008"},
  });
}

TEST_F(ErrorKeeper, SaysWhatIsLeftWhenAnErrorGoes) {
  start();
  EXPECT_EQ(raises(0x3210, 1, 0x04), (Lines{"085#1032050100000000"}));
  EXPECT_EQ(raises(0x4310, 2, 0x08), (Lines{"085#10430D0200000000"}));

  EXPECT_EQ(clears(0x3210, 1), (Lines{"085#0000090000000000"}));
  EXPECT_EQ(clears(0x4310, 2), (Lines{"085#0000000000000000"}));
  expect_dialogue({{kReadRegister, "585#4F01100000000000"}});
}

TEST_F(ErrorKeeper, KeepsABitOfTheRegisterAsLongAsAnyErrorHasIt) {
  start();
  raises(0x3210, 1, 0x04);
  raises(0x3220, 1, 0x04);

  EXPECT_EQ(clears(0x3210, 1), (Lines{"085#0000050000000000"}));
  EXPECT_EQ(clears(0x3220, 1), (Lines{"085#0000000000000000"}));
}

TEST_F(ErrorKeeper, SendsAnErrorOnceWhileItLasts) {
  start();
  raises(0x3210, 1, 0x04);

  EXPECT_EQ(raises(0x3210, 1, 0x04), Lines{});
  EXPECT_EQ(raises(0x3210, 2, 0x04).size(), 1U) << "another detail is another error";
  EXPECT_EQ(value_of(0x1003), 2);

  clears(0x3210, 1);
  EXPECT_EQ(raises(0x3210, 1, 0x04).size(), 1U);
}

TEST_F(ErrorKeeper, SaysNothingOfTheEndOfAnErrorThatNeverWas) {
  start();
  raises(0x3210, 1, 0x04);

  EXPECT_EQ(clears(0x3210, 2), Lines{});
  EXPECT_EQ(clears(0x3211, 1), Lines{});
  clears(0x3210, 1);
  EXPECT_EQ(clears(0x3210, 1), Lines{});
}

TEST_F(ErrorKeeper, LogsTheNewestFirstAndForgetsTheOldest) {
  start();
  for (std::uint16_t code = 1; code <= 6; ++code) raises(code, 0, 0);

  expect_dialogue({
      {kReadCount, "585#4F03100004000000"},
      {"605#4003100100000000", "585#4303100106000000"},
      {"605#4003100200000000", "585#4303100205000000"},
      {"605#4003100300000000", "585#4303100304000000"},
      {"605#4003100400000000", "585#4303100403000000"},
  });
}

TEST_F(ErrorKeeper, DoesNotLogThatAnErrorHasGone) {
  start();
  raises(0x3210, 0, 0x04);

  clears(0x3210, 0);

  expect_dialogue({
      {kReadCount, "585#4F03100001000000"},
      {"605#4003100100000000", "585#4303100110320000"},
  });
}

TEST_F(ErrorKeeper, EmptiesItsHistoryWhen0IsWritten) {
  start();
  raises(0x3210, 0, 0x04);

  EXPECT_EQ(writes_u8(0x1003, 0, 1), 0x06090030U);
  EXPECT_EQ(value_of(0x1003), 1);
  EXPECT_EQ(writes_u8(0x1003, 0, 0), 0U);

  expect_dialogue({
      {kReadCount, "585#4F03100000000000"},
      {"605#4003100100000000", "585#8003100124000008"},
      {kReadRegister, "585#4F01100005000000"},  // the error is still there
  });
  raises(0x4310, 0, 0x08);
  expect_dialogue({
      {kReadCount, "585#4F03100001000000"},
      {"605#4003100100000000", "585#4303100110430000"},
  });
}

TEST_F(ErrorKeeper, SendsMoreErrorsThanItKeeps) {
  start();
  for (std::uint16_t detail = 0; detail < 32; ++detail) raises(0x3210, detail, 0x04);

  EXPECT_EQ(raises(0x4310, 0, 0x08), (Lines{"085#10430D0000000000"}));
  EXPECT_EQ(clears(0x4310, 0), Lines{});
  EXPECT_EQ(value_of(0x1001), 0x05);

  for (std::uint16_t detail = 0; detail < 32; ++detail) EXPECT_EQ(clears(0x3210, detail).size(), 1U);
  EXPECT_EQ(value_of(0x1001), 0);
}

TEST_F(ErrorKeeper, KeepsErrorsInStoppedWithoutAWord) {
  start();
  says("000#0205");

  EXPECT_EQ(raises(0x3210, 1, 0x04), Lines{});
  says("000#8005");

  expect_dialogue({{kReadRegister, "585#4F01100005000000"}, {kReadCount, "585#4F03100001000000"}});
  EXPECT_EQ(clears(0x3210, 1), (Lines{"085#0000000000000000"}));
}

TEST_F(ErrorKeeper, ForgetsEverythingWithAReset) {
  for (const char* const command : {"000#8105", "000#8205"}) {
    start();
    raises(0x3210, 1, 0x04);

    EXPECT_EQ(says(command), (Lines{"705#00"}));

    expect_dialogue({{kReadRegister, "585#4F01100000000000"}, {kReadCount, "585#4F03100000000000"}});
    EXPECT_EQ(raises(0x3210, 1, 0x04), (Lines{"085#1032050100000000"})) << "raised again";
  }
}

TEST_F(ErrorKeeper, KeepsItsHistoryWhenTheNodeIsStartedAgain) {
  start();
  raises(0x3210, 1, 0x04);

  EXPECT_EQ(start(), (Lines{"705#00"}));

  expect_dialogue({
      {kReadRegister, "585#4F01100000000000"},
      {kReadCount, "585#4F03100001000000"},
      {"605#4003100100000000", "585#4303100110320100"},
  });
}

TEST_F(ErrorKeeper, TakesTheErrorsOfTheCommunicationByItself) {
  start();

  node->report(CommunicationError::ErrorPassive, now);
  EXPECT_EQ(sent(), (Lines{"085#2081110000000000"}));
  EXPECT_EQ(errors(), (Lines{"8120 0"}));

  node->report_recovery(CommunicationError::ErrorPassive, now);
  EXPECT_EQ(sent(), (Lines{"085#0000000000000000"}));
  EXPECT_EQ(errors(), (Lines{"8120 0 over"}));
}

TEST_F(ErrorKeeper, ShowsTheRegisterInATpdoOnItsChange) {
  start();
  ASSERT_EQ(writes_u32(0x1800, 1, 0x40000185), 0U);
  says("000#0105");

  EXPECT_EQ(raises(0x3210, 1, 0x04), (Lines{"085#1032050100000000", "185#05"}));
  EXPECT_EQ(clears(0x3210, 1), (Lines{"085#0000000000000000", "185#00"}));
}

class ErrorsOfTheOwner : public ErrorKeeper {
 protected:
  ErrorsOfTheOwner()
      : ErrorKeeper{Policy{.error_keeping = canopen::ErrorKeeping::Owner, .extended_identifiers = false}} {}
};

TEST_F(ErrorsOfTheOwner, AreLeftAlone) {
  store_value(0x1001, 0, 0x81);
  store_value(0x1003, 0, 2);
  start();

  EXPECT_EQ(raises(0x3210, 1, 0x04), Lines{});
  EXPECT_EQ(clears(0x3210, 1), Lines{});
  node->report(CommunicationError::ErrorPassive, now);

  EXPECT_EQ(sent(), Lines{});
  EXPECT_EQ(errors(), (Lines{"8120 0"})) << "the owner is told";
  EXPECT_EQ(value_of(0x1001), 0x81);
  EXPECT_EQ(value_of(0x1003), 2);
  EXPECT_EQ(says("605#4003100400000000"), (Lines{"585#4303100400000000"})) << "any layout";
  EXPECT_EQ(writes_u8(0x1003, 0, 9), 0U) << "any value";
}

}  // namespace
