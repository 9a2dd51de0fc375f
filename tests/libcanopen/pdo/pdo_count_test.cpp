#include "tests/libcanopen/fixture/pdo_parameters_fixture.hpp"

/// Sub-index 0 of mappings that counts the entries by itself.
namespace {

using canopen::Policy;

class PdoParametersThatCount : public PdoParameters {
 protected:
  PdoParametersThatCount() : PdoParameters{Policy{.count_follows_entries = true}} {}
};

TEST_F(PdoParametersThatCount, CountTheirEntriesUpToTheFirstEmptyOne) {
  expect_writes({{0x1603, 1, 4, 0x60400010, 0}});
  EXPECT_EQ(value_of(0x1603, 0), 1);
  expect_writes({{0x1603, 3, 4, 0x60600008, 0}});
  EXPECT_EQ(value_of(0x1603, 0), 1);
  expect_writes({{0x1603, 2, 4, 0x60FF0020, 0}});
  EXPECT_EQ(value_of(0x1603, 0), 3);
  expect_writes({{0x1603, 2, 4, 0, 0}});
  EXPECT_EQ(value_of(0x1603, 0), 1);
  expect_writes({
      {0x1603, 2, 4, 0x60FF0020, 0},
      {0x1603, 4, 4, 0x20180020, kTooLong},  // an eleventh byte
      {0x1403, 1, 4, 0x00000505, 0},
  });
  EXPECT_EQ(value_of(0x1603, 4), 0);

  says("000#0105");
  says("505#0F0078563412FD");

  EXPECT_EQ(value_of(0x6040), 0x000F);
  EXPECT_EQ(value_of(0x60FF), 0x12345678);
  EXPECT_EQ(value_of(0x6060), -3);
}

TEST_F(PdoParametersThatCount, TakeTheProcedureOfCiA301AsWell) {
  expect_writes({
      {0x1400, 1, 4, 0x80000205, 0},
      {0x1600, 0, 1, 0, 0},
      {0x1600, 1, 4, 0x60600008, 0},
      {0x1600, 2, 4, 0x60400010, 0},
  });
  EXPECT_EQ(value_of(0x1600, 0), 0) << "0 was written";
  expect_writes({
      {0x1600, 0, 1, 2, 0},
      {0x1400, 1, 4, 0x00000205, 0},
      {0x1600, 1, 4, 0x60600008, kDeviceState},
  });
  EXPECT_EQ(value_of(0x1600, 0), 2);
}

TEST_F(PdoParametersThatCount, CountWhenTheyBecomeValidWhatWasWrittenAfterAZero) {
  expect_writes({
      {0x1603, 0, 1, 0, 0},
      {0x1603, 1, 4, 0x60400010, 0},
      {0x1603, 2, 4, 0x60600008, 0},
      {0x1403, 1, 4, 0x80000505, 0},  // invalid, as it was
  });
  EXPECT_EQ(value_of(0x1603, 0), 0);

  expect_writes({{0x1403, 1, 4, 0x00000505, 0}});

  EXPECT_EQ(value_of(0x1603, 0), 2);
  says("000#0105");
  says("505#0F00FD");
  EXPECT_EQ(value_of(0x6040), 0x000F);
  EXPECT_EQ(value_of(0x6060), -3);
}

TEST_F(PdoParametersThatCount, StayInvalidWhenWhatWasWrittenAfterAZeroIsTooLong) {
  expect_writes({
      {0x1603, 0, 1, 0, 0},
      {0x1603, 1, 4, 0x60FF0020, 0},
      {0x1603, 2, 4, 0x20180020, 0},
      {0x1603, 3, 4, 0x60600008, 0},
      {0x1403, 1, 4, 0x00000505, kTooLong},
  });
  EXPECT_EQ(value_of(0x1603, 0), 0);
  expect_writes({{0x1603, 3, 4, 0, 0}, {0x1403, 1, 4, 0x00000505, 0}});
  EXPECT_EQ(value_of(0x1603, 0), 2);
}

TEST_F(PdoParametersThatCount, StayEmptyWhenNothingWasWrittenAfterAZero) {
  expect_writes({
      {0x1400, 1, 4, 0x80000205, 0},
      {0x1600, 0, 1, 0, 0},
      {0x1400, 1, 4, 0x00000205, 0},
  });
  EXPECT_EQ(value_of(0x1600, 0), 0);
}

TEST_F(PdoParametersThatCount, ForgetAWrittenZeroWithTheNextInvalidCobId) {
  expect_writes({
      {0x1400, 1, 4, 0x80000205, 0},
      {0x1600, 0, 1, 0, 0},
      {0x1400, 1, 4, 0x80000205, 0},
      {0x1600, 1, 4, 0x60600008, 0},
  });
  EXPECT_GE(value_of(0x1600, 0), 1) << "it follows the entries again";
}

}  // namespace
