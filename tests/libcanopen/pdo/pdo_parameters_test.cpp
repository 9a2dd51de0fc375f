#include "tests/libcanopen/fixture/pdo_parameters_fixture.hpp"

namespace {

using canopen::Policy;

TEST_F(PdoParameters, AreInvalidWithBit31WhateverElseIsSet) {
  for (const std::uint32_t cob_id :
       {0x80000205U, 0x800006DFU, 0xC00006E0U, 0xFFFFFFFFU, 0x80000000U, 0xA0000605U}) {
    EXPECT_EQ(writes_u32(0x1400, 1, cob_id), 0U) << std::hex << cob_id;
    EXPECT_EQ(value_of(0x1400, 1), cob_id);
    EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0, 0x80, 0x305, 0x405, 0x585, 0x605, 0x705}));
  }
}

TEST_F(PdoParameters, ChangeFromOneIdentifierToAnotherOnlyThroughInvalid) {
  expect_writes({
      {0x1400, 1, 4, 0x00000205, 0},  // as it is
      {0x1400, 1, 4, 0x00000206, kDeviceState},
      {0x1400, 1, 4, 0x80000206, 0},
      {0x1400, 1, 4, 0x00000206, 0},
      {0x1800, 1, 4, 0x40000186, kDeviceState},
      {0x1800, 1, 4, 0x00000185, 0},  // bit 30 is free
      {0x1800, 1, 4, 0xC0000186, 0},
      {0x1800, 1, 4, 0x40000186, 0},
  });
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0, 0x80, 0x206, 0x305, 0x405, 0x585, 0x605, 0x705}));
  EXPECT_EQ(value_of(0x1800, 1), 0x40000186);
}

TEST_F(PdoParameters, RefuseIdentifiersOf29BitsAndRestrictedOnes) {
  ASSERT_EQ(writes_u32(0x1403, 1, 0x80000000), 0U);
  for (const std::uint32_t cob_id :
       {0x20000405U, 0x00000800U, 0x10000405U, 0x1FFFFFFFU, 0x00000000U, 0x00000001U, 0x0000007FU, 0x00000101U,
        0x00000180U, 0x00000581U, 0x000005FFU, 0x00000601U, 0x0000067FU, 0x000006E0U, 0x000006FFU, 0x00000701U,
        0x0000077FU, 0x00000780U, 0x000007FFU}) {
    EXPECT_EQ(writes_u32(0x1403, 1, cob_id), kInvalidValue) << std::hex << cob_id;
    EXPECT_EQ(writes_u32(0x1803, 1, cob_id), kInvalidValue) << std::hex << cob_id;
  }
  EXPECT_EQ(value_of(0x1403, 1), 0x80000000);
}

TEST_F(PdoParameters, TakeTheIdentifiersBesideTheRestrictedOnes) {
  for (const std::uint32_t identifier : {0x100U, 0x181U, 0x57FU, 0x580U, 0x600U, 0x680U, 0x6DFU, 0x700U, 0x086U}) {
    EXPECT_EQ(writes_u32(0x1403, 1, identifier), 0U) << std::hex << identifier;
    EXPECT_EQ(writes_u32(0x1403, 1, 0x80000000), 0U);
  }
}

TEST_F(PdoParameters, RefuseIdentifiersThatTheNodeUsesAlready) {
  expect_writes({
      {0x1403, 1, 4, 0x00000205, kInUse},  // RPDO 1
      {0x1403, 1, 4, 0x00000185, kInUse},  // TPDO 1
      {0x1403, 1, 4, 0x00000080, kInUse},  // SYNC
      {0x1403, 1, 4, 0x00000085, kInUse},  // EMCY
      {0x1803, 1, 4, 0x40000305, kInUse},
      {0x1803, 1, 4, 0x40000285, kInUse},
      {0x1400, 1, 4, 0x80000205, 0},
      {0x1403, 1, 4, 0x00000205, 0},  // given up by RPDO 1
      {0x1400, 1, 4, 0x00000205, kInUse},
      {0x1014, 0, 4, 0x80000085, 0},
      {0x1803, 1, 4, 0x40000085, 0},  // given up by EMCY
  });
}

TEST_F(PdoParameters, ChangeTheMappingOnlyWhileInvalid) {
  expect_writes({
      {0x1600, 0, 1, 0, kDeviceState},
      {0x1600, 1, 4, 0x60600008, kDeviceState},
      {0x1A00, 0, 1, 0, kDeviceState},
      {0x1400, 1, 4, 0x80000205, 0},
      {0x1600, 1, 4, 0x60600008, kDeviceState},  // the count is not 0 yet
      {0x1600, 0, 1, 0, 0},
      {0x1600, 1, 4, 0x60600008, 0},
      {0x1600, 0, 1, 1, 0},
      {0x1400, 1, 4, 0x00000205, 0},
  });
  says("000#0105");
  says("205#07");
  EXPECT_EQ(value_of(0x6060), 7);
}

TEST_F(PdoParameters, RefuseWhatCannotBeMapped) {
  expect_writes({
      {0x1603, 1, 4, 0x20000008, kUnmappable},  // not mappable
      {0x1603, 1, 4, 0x10080008, kUnmappable},  // a text
      {0x1603, 1, 4, 0x60410010, kUnmappable},  // ro in an RPDO
      {0x1A03, 1, 4, 0x60400010, kUnmappable},  // rww in a TPDO
      {0x1A03, 1, 4, 0x20200010, kUnmappable},  // wo in a TPDO
      {0x1A03, 1, 4, 0x20220020, kUnmappable},  // const
      {0x1603, 1, 4, 0x60400008, kUnmappable},  // half an object
      {0x1603, 1, 4, 0x60400020, kUnmappable},  // more than an object
      {0x1603, 1, 4, 0x60400000, kUnmappable},
      {0x1603, 1, 4, 0x60420010, 0x06020000},
      {0x1603, 1, 4, 0x60400110, 0x06090011},
      {0x1603, 1, 4, 0x60400010, 0},
      {0x1603, 0, 1, 2, kUnmappable},  // the second entry is empty
      {0x1603, 0, 1, 1, 0},
      {0x1603, 0, 1, 5, 0x06090031},  // the record has four
  });
  EXPECT_EQ(value_of(0x1603, 1), 0x60400010);
}

TEST_F(PdoParameters, RefuseMoreThanEightBytes) {
  expect_writes({
      {0x1A03, 1, 4, 0x20180020, 0},
      {0x1A03, 2, 4, 0x20190020, 0},
      {0x1A03, 3, 4, 0x20110008, 0},
      {0x1A03, 0, 1, 3, kTooLong},
      {0x1A03, 0, 1, 2, 0},
      {0x1803, 1, 4, 0x40000485, 0},
  });
  EXPECT_EQ(says("000#0105"), (Lines{"185#4000", "485#0000000000000000"}));
}

TEST_F(PdoParameters, RefuseReservedTransmissionTypes) {
  for (std::uint32_t type = 0; type <= 0xFF; ++type) {
    EXPECT_EQ(writes_u8(0x1400, 2, type), type >= 0xF1 && type <= 0xFD ? kInvalidValue : 0) << type;
    EXPECT_EQ(writes_u8(0x1800, 2, type), type >= 0xF1 && type <= 0xFB ? kInvalidValue : 0) << type;
  }
}

TEST_F(PdoParameters, ChangeTheInhibitTimeOnlyWhileInvalid) {
  expect_writes({
      {0x1800, 3, 2, 100, kDeviceState},
      {0x1800, 5, 2, 100, 0},
      {0x1800, 1, 4, 0xC0000185, 0},
      {0x1800, 3, 2, 100, 0},
      {0x1803, 3, 2, 100, 0},
  });
  EXPECT_EQ(value_of(0x1800, 3), 100);
}

TEST_F(PdoParameters, MayBeChangedInOperationalByDefault) {
  says("000#0105");
  expect_writes({
      {0x1800, 1, 4, 0xC0000185, 0},
      {0x1A00, 0, 1, 0, 0},
      {0x1A00, 1, 4, 0x60610008, 0},
      {0x1A00, 0, 1, 1, 0},
      {0x1800, 1, 4, 0x40000185, 0},
  });
  EXPECT_EQ(passes(0ms), (Lines{"0ms 185#00"}));
}

TEST_F(PdoParameters, ReturnToTheirInitialValuesAfterResetCommunication) {
  expect_writes({
      {0x1400, 1, 4, 0x80000205, 0},
      {0x1600, 0, 1, 0, 0},
      {0x1600, 1, 4, 0x60600008, 0},
      {0x1600, 0, 1, 1, 0},
      {0x1400, 1, 4, 0x00000456, 0},
      {0x1400, 2, 1, 1, 0},
  });

  says("000#8205");
  says("000#0105");
  says("456#0F00");
  EXPECT_EQ(value_of(0x6040), 1);
  says("205#0F00");

  EXPECT_EQ(value_of(0x6040), 0x0F);
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0, 0x80, 0x205, 0x305, 0x405, 0x585, 0x605, 0x705}));
}

TEST_F(PdoParameters, TellTheApplicationOfEveryChangeOfAnIdentifier) {
  const int before = application.subscription_changes;

  writes_u32(0x1400, 1, 0x80000205);
  EXPECT_EQ(application.subscription_changes, before + 1);
  writes_u32(0x1400, 1, 0x00000206);
  EXPECT_EQ(application.subscription_changes, before + 2);
  writes_u32(0x1400, 1, 0x00000207);  // refused
  EXPECT_EQ(application.subscription_changes, before + 2);
}

class PdoParametersOfFewTypes : public PdoParameters {
 protected:
  static constexpr std::array kTypes{canopen::TypeRange{1, 2}, canopen::TypeRange{255, 255}};
  PdoParametersOfFewTypes() : PdoParameters{Policy{.rpdo_types = kTypes, .tpdo_types = kTypes}} {}
};

TEST_F(PdoParametersOfFewTypes, TakeNoOtherTransmissionType) {
  expect_writes({
      {0x1400, 2, 1, 0, kInvalidValue},
      {0x1400, 2, 1, 1, 0},
      {0x1400, 2, 1, 3, kInvalidValue},
      {0x1800, 2, 1, 2, 0},
      {0x1800, 2, 1, 254, kInvalidValue},
      {0x1800, 2, 1, 255, 0},
  });
}

class PdoParametersLockedInOperational : public PdoParameters {
 protected:
  PdoParametersLockedInOperational() : PdoParameters{Policy{.pdo_changes_in_operational = false}} {}
};

TEST_F(PdoParametersLockedInOperational, AreRefusedThereAndTakenElsewhere) {
  says("000#0105");
  expect_writes({
      {0x1400, 1, 4, 0x80000205, kDeviceState},
      {0x1400, 2, 1, 1, kDeviceState},
      {0x1800, 5, 2, 100, kDeviceState},
      {0x1803, 3, 2, 100, kDeviceState},
      {0x1A03, 0, 1, 0, kDeviceState},
      {0x1A03, 1, 4, 0x60410010, kDeviceState},
      {0x1017, 0, 2, 100, 0},  // nothing of a PDO
  });
  says("000#8005");
  expect_writes({{0x1400, 1, 4, 0x80000205, 0}});
}

}  // namespace
