#include "libcanopen/sdo/command.hpp"
#include "tests/libcanopen/fixture/sdo_servers_fixture.hpp"

namespace {

/// Servers that may have the identifiers of the pre-defined connection set, on node 5.
class SdoServersOfPredefinedIdentifiers : public SdoServers {
 protected:
  SdoServersOfPredefinedIdentifiers()
      : SdoServers{{.extended_identifiers = false, .predefined_sdo_identifiers = true}} {}
  /// Gives 1201h its two identifiers.
  void connect(std::uint32_t request, std::uint32_t response) {
    EXPECT_EQ(writes_u32(0x1201, 1, request), 0U) << std::hex << request;
    EXPECT_EQ(writes_u32(0x1201, 2, response), 0U) << std::hex << response;
  }
};

TEST_F(SdoServersOfPredefinedIdentifiers, WorkUnderThoseOfOtherNodes) {
  connect(0x606, 0x586);
  EXPECT_EQ(says("606#4000100000000000"), (Lines{"586#4300100092010200"}));
  EXPECT_EQ(says("605#4000100000000000"), (Lines{"585#4300100092010200"}));

  for (const std::uint32_t other : {1U, 4U, 127U}) {
    connect(0x80000000, 0x80000000);
    connect(0x600 + other, 0x40000580 + other);
    EXPECT_EQ(says(fakes::candump(canopen::sdo::response(0x600 + other, 0x40, {0x1000, 0}, 0))).size(), 1U);
  }
  connect(0x80000000, 0x80000000);
  connect(0x690, 0x581);
  EXPECT_EQ(says("690#4000100000000000"), (Lines{"581#4300100092010200"}));
}

TEST_F(SdoServersOfPredefinedIdentifiers, ListenAndAnswerEachInItsOwnRange) {
  for (const std::uint32_t cob_id : {0x581U, 0x5FFU, 0x6E0U, 0x701U, 0x77FU, 0x000U, 0x10000601U, 0x20000601U}) {
    EXPECT_EQ(writes_u32(0x1201, 1, cob_id), kInvalidValue) << std::hex << cob_id;
  }
  for (const std::uint32_t cob_id : {0x601U, 0x67FU, 0x6FFU, 0x701U, 0x101U, 0x000U, 0x10000581U, 0x20000581U}) {
    EXPECT_EQ(writes_u32(0x1201, 2, cob_id), kInvalidValue) << std::hex << cob_id;
  }
}

TEST_F(SdoServersOfPredefinedIdentifiers, LeaveThoseOfTheFirstServerToIt) {
  EXPECT_EQ(writes_u32(0x1201, 1, 0x605), kIncompatible);
  EXPECT_EQ(writes_u32(0x1201, 2, 0x585), kIncompatible);

  store_ids(0x1200, 0x690, 0x691);
  store_ids(0x1201, 0x605, 0x692);
  store_ids(0x1202, 0x605, 0x80000000);
  start();
  EXPECT_EQ(value_of(0x1201, 1), 0x80000605);
  EXPECT_EQ(value_of(0x1202, 1), 0x80000605);
  says("690#2301120110060000");
  EXPECT_EQ(value_of(0x1201, 1), 0x610);
  EXPECT_EQ(says("690#2303120105060000"), (Lines{"691#8003120143000406"})) << "nobody listens to it";
}

TEST_F(SdoServersOfPredefinedIdentifiers, TakeNoneThatAnotherServerHas) {
  connect(0x606, 0x586);
  EXPECT_EQ(writes_u32(0x1202, 1, 0x606), kIncompatible);
  EXPECT_EQ(writes_u32(0x1202, 2, 0x586), kIncompatible);
}

TEST_F(SdoServersOfPredefinedIdentifiers, MayBeStored) {
  store_ids(0x1201, 0x606, 0x586);
  store_ids(0x1202, 0x606, 0x587);  // as that of 1201h
  store_ids(0x1203, 0x588, 0x608);  // the wrong way round
  start();
  EXPECT_EQ(says("606#4000100000000000"), (Lines{"586#4300100092010200"}));
  EXPECT_EQ(says("588#4000100000000000"), Lines{});
  EXPECT_EQ(value_of(0x1202, 1), 0x80000606);
  EXPECT_EQ(value_of(0x1203, 1), 0x80000588);
}

TEST_F(SdoServersOfPredefinedIdentifiers, AreNoMatterOfOtherServices) {
  EXPECT_EQ(writes_u32(0x1400, 1, 0x80000205), 0U);
  EXPECT_EQ(writes_u32(0x1400, 1, 0x606), kInvalidValue);
}

}  // namespace
