#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr std::string_view kDone1401 = "585#6001140100000000";

/// Plays @p exchanges and compares the answers; the alarms of refusals are shown elsewhere.
void expect_answers(TestUnit& unit, std::initializer_list<Exchange> exchanges) {
  for (const Exchange& exchange : exchanges)
    EXPECT_EQ(from("585#", unit.says(exchange.request)), Lines{std::string{exchange.answer}}) << exchange.request;
}

TEST(PdoMapping, OfAnRpdoChangesByTheProcedureOfCia301) {
  TestUnit unit;
  unit.start();

  unit.expect_dialogue({
      {"605#2301140105030080", kDone1401},               // COB-ID invalid
      {"605#2F01160000000000", "585#6001160000000000"},  // no entry
      {"605#2301160110004060", "585#6001160100000000"},  // 6040h
      {"605#2301160210007160", "585#6001160200000000"},  // 6071h
      {"605#230116032000FF60", "585#6001160300000000"},  // 60FFh
      {"605#2F01160003000000", "585#6001160000000000"},  // three entries
      {"605#2301140105030000", kDone1401},               // COB-ID valid
      {"605#4001160000000000", "585#4F01160003000000"},
  });
  unit.says("000#0105");
  unit.cycles_with("305#0600F4010000800C");

  EXPECT_EQ(unit.statusword(), 0x1631);
  EXPECT_EQ(unit.upload(0x6071).number(), 500U);
  EXPECT_EQ(unit.upload(0x60FF).number(), 0x0C800000U);
}

TEST(PdoMapping, OfATpdoChangesByTheProcedureOfCia301) {
  TestUnit unit;
  unit.start();

  unit.expect_dialogue({
      {"605#2300180185010080", "585#6000180100000000"},
      {"605#2F001A0000000000", "585#60001A0000000000"},
      {"605#23001A0108006160", "585#60001A0100000000"},  // 6061h
      {"605#23001A0210004160", "585#60001A0200000000"},  // 6041h
      {"605#23001A0320006C60", "585#60001A0300000000"},  // 606Ch
      {"605#2F001A0003000000", "585#60001A0000000000"},
      {"605#2300180185010000", "585#6000180100000000"},
  });

  EXPECT_EQ(from("185#", unit.says("000#0105")), Lines{"185#03401600000000"});
}

TEST(PdoMapping, ChangesByTheShortProcedureOfTheUnitToo) {
  TestUnit unit;
  unit.start();

  unit.expect_dialogue({
      {"605#2300140105020080", "585#6000140100000000"},
      {"605#230016022000FF60", "585#6000160200000000"},  // after 6040h
      {"605#4000160000000000", "585#4F00160002000000"},  // the count has followed
      {"605#2300140105020000", "585#6000140100000000"},
  });
  unit.says("000#0105");
  unit.cycles_with("205#06000000800C");

  EXPECT_EQ(unit.statusword(), 0x1631);
  EXPECT_EQ(unit.upload(0x60FF).number(), 0x0C800000U);
}

TEST(PdoMapping, MovesAPdoToAnotherIdentifier) {
  TestUnit unit;
  unit.start();
  const int before = unit.listener.subscription_changes;

  ASSERT_EQ(unit.download(0x1400, 1, 0x80000205, 4), 0U);
  ASSERT_EQ(unit.download(0x1400, 1, 0x00000195, 4), 0U);

  EXPECT_GE(unit.listener.subscription_changes, before + 2);
  EXPECT_EQ(unit.device.subscriptions()[2].identifier, 0x195U);
  unit.says("000#0105");
  EXPECT_EQ(unit.cycles_with("205#0600"), Lines{});
  EXPECT_EQ(unit.cycles_with("195#0600"), at_rest(0x1631));
}

TEST(PdoMapping, IsRefusedWhileTheCobIdIsValid) {
  TestUnit unit;
  unit.start();

  expect_answers(unit, {
                           {"605#2F00160000000000", "585#8000160022000008"},
                           {"605#230016022000FF60", "585#8000160222000008"},
                           {"605#2300140115020000", "585#8000140122000008"},  // another valid COB-ID
                           {"605#2B00180364000000", "585#8000180322000008"},  // inhibit time
                       });
}

TEST(PdoMapping, IsRefusedInOperational) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1401, 1, 0x80000305, 4), 0U);
  unit.says("000#0105");

  expect_answers(unit, {
                           {"605#2F01160000000000", "585#8001160022000008"},
                           {"605#2301160110004060", "585#8001160122000008"},
                           {"605#2301140105030000", "585#8001140122000008"},
                           {"605#2300140105020080", "585#8000140122000008"},
                           {"605#2F00180201000000", "585#8000180222000008"},
                       });
}

TEST(PdoMapping, RefusesWhatCannotBeMapped) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1401, 1, 0x80000305, 4), 0U);
  ASSERT_EQ(unit.download(0x1800, 1, 0x80000185, 4), 0U);

  expect_answers(unit, {
                           {"605#2301160110004160", "585#8001160141000406"},  // statusword in an RPDO
                           {"605#2301160108004060", "585#8001160141000406"},  // 8 bits of 16
                           {"605#2301160120008360", "585#8001160141000406"},  // 6083h
                           {"605#2301160108000500", "585#8001160141000406"},  // dummy entry
                           {"605#2301160110004068", "585#8001160141000406"},  // 6840h: no second axis
                           {"605#2301160110014060", "585#8001160141000406"},  // sub-index 1
                           {"605#23001A0120000010", "585#80001A0141000406"},  // 1000h
                       });
}

TEST(PdoMapping, RefusesMoreThanEightBytes) {
  TestUnit unit;
  unit.start();

  expect_answers(unit,
                 {
                     {"605#2303140105050080", "585#6003140100000000"},
                     {"605#230316042000FF60", "585#8003160442000406"},  // 2 + 4 + 2 + 4 bytes, short procedure
                     {"605#2F03160000000000", "585#6003160000000000"},
                     {"605#230316042000FF60", "585#6003160400000000"},
                     {"605#2F03160004000000", "585#8003160042000406"},  // the same, procedure of CiA 301
                     {"605#2F03160005000000", "585#8003160031000906"},
                 });
}

TEST(PdoMapping, RefusesAnIdentifierThatIsInUse) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1400, 1, 0x80000205, 4), 0U);
  ASSERT_EQ(unit.download(0x1800, 1, 0x80000185, 4), 0U);

  for (const std::uint32_t used : {0x305U, 0x285U, 0x085U, 0x080U})
    EXPECT_EQ(unit.download(0x1400, 1, used, 4), 0x06040043U) << std::hex << used;
  EXPECT_EQ(unit.download(0x1800, 1, 0x305, 4), 0x06040043U);
  EXPECT_EQ(unit.download(0x1400, 1, 0x185, 4), 0U);
}

TEST(PdoMapping, RefusesIdentifiersThatCia301Restricts) {
  TestUnit unit;
  unit.start();
  ASSERT_EQ(unit.download(0x1400, 1, 0x80000205, 4), 0U);

  for (const std::uint32_t restricted :
       {0x000U, 0x001U, 0x101U, 0x585U, 0x605U, 0x6E0U, 0x705U, 0x7FFU, 0x20000205U})
    EXPECT_EQ(unit.download(0x1400, 1, restricted, 4), 0x06090030U) << std::hex << restricted;
}

TEST(PdoMapping, AcceptsEveryValueWithBit31AsInvalid) {
  TestUnit unit;
  unit.start();

  for (const std::uint32_t invalid : {0x80000000U, 0xC00006E0U, 0x80000205U, 0xFFFFFFFFU}) {
    EXPECT_EQ(unit.download(0x1400, 1, invalid, 4), 0U) << std::hex << invalid;
    EXPECT_EQ(unit.download(0x1800, 1, invalid, 4), 0U) << std::hex << invalid;
  }
  EXPECT_EQ(unit.says("000#0105").size(), 3U);
  EXPECT_EQ(unit.cycles_with("205#0600"), Lines{});
}

TEST(TransmissionTypes, AreThoseOfTheUnit) {
  TestUnit unit;
  unit.start();

  for (std::uint32_t type = 0; type <= 0xFF; ++type) {
    const std::uint32_t expected = type <= 0xF0 || type >= 0xFE ? 0U : 0x06090030U;
    EXPECT_EQ(unit.download(0x1400, 2, type, 1), expected) << type;
    EXPECT_EQ(unit.download(0x1800, 2, type, 1), expected) << type;
  }
}

TEST(PdoMapping, CarriesFreeObjectsInTheFurtherPdosOfAnAxis) {
  TestUnit unit;
  unit.start();

  unit.expect_dialogue({
      {"605#2304160110000058", "585#6004160100000000"},  // 5800h
      {"605#2304160220002058", "585#6004160200000000"},  // 5820h
      {"605#2304140112030000", "585#6004140100000000"},
  });
  unit.says("000#0105");
  unit.says("312#FECA78563412");

  EXPECT_EQ(unit.upload(0x5800).number(), 0xCAFEU);
  EXPECT_EQ(unit.upload(0x5820).number(), 0x12345678U);
}

TEST(PdoMapping, ReachesTheObjectsOfEveryAxis) {
  Configuration configuration = unit_with({});
  configuration.axes.resize(2);
  TestUnit unit{configuration};
  unit.start();

  unit.expect_dialogue({
      {"605#2341140113030000", "585#6041140100000000"},  // RPDO 2 of axis 2: 6840h and 68FFh
      {"605#2340180191010040", "585#6040180100000000"},  // TPDO 1 of axis 2: 6841h
  });
  EXPECT_EQ(from("191#", unit.says("000#0105")), Lines{"191#4016"});
  unit.says("313#0F0078563412");

  EXPECT_EQ(unit.upload(0x6840).number(), 0x000FU);
  EXPECT_EQ(unit.upload(0x68FF).number(), 0x12345678U);
  EXPECT_EQ(unit.upload(0x6040).number(), 0U) << "axis 1 is not concerned";
}

}  // namespace
}  // namespace device
