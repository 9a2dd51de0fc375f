#include "tests/device/test_unit.hpp"

namespace device {
namespace {

TEST(Unit, SendsItsBootUpMessageAtStartAndNothingElse) {
  TestUnit unit;

  EXPECT_EQ(unit.start(), Lines{"705#00"});
  EXPECT_EQ(unit.passes(10s), Lines{});
}

TEST(Unit, AnswersSdoRequestsAsTheDriveUnitDoes) {
  TestUnit unit;
  unit.start();

  unit.expect_dialogue({
      {"605#4000100000000000", "585#430010009201FFFF"},
      {"605#4008100000000000", "585#4108100008000000"},
      {"605#6000000000000000", "585#0053494E414D4943"},
      {"605#7000000000000000", "585#1D53000000000000"},
      {"605#4002650000000000", "585#430265000E000000"},
      {"605#2B41600001000000", "585#8041600002000106"},
      {"605#2B07600004000000", "585#8007600031000906"},
      {"605#4018100500000000", "585#8018100511000906"},
      {"605#40001F0000000000", "585#80001F0000000206"},
      {"605#27171000E8030000", "585#8017100010000706"},
  });
}

TEST(Unit, IsSilentToWhatIsNoRequest) {
  TestUnit unit;
  unit.start();

  unit.expect_dialogue({
      {"605#8000100000000005", ""},  // abort by the client
      {"605#R8", ""},
      {"605#40001000000000", ""},    // seven bytes
      {"604#4000100000000000", ""},  // another node
      {"00000605#4000100000000000", ""},
  });
}

TEST(Unit, AnswersNodeGuardingWithAToggleBit) {
  TestUnit unit;
  unit.start();

  unit.expect_dialogue({{"705#R", "705#7F"}, {"705#R", "705#FF"}, {"705#R", "705#7F"}});
}

TEST(Unit, HasHeartbeatOrLifeGuardingButNotBoth) {
  TestUnit unit;
  unit.start();

  unit.expect_dialogue({
      {"605#2B0C100064000000", "585#600C100000000000"},  // 100 ms
      {"605#2F0D100003000000", "585#600D100000000000"},  // times three
      {"605#2B171000E8030000", "585#8017100022000008"},
      {"605#2B17100000000000", "585#6017100000000000"},
      {"605#2F0D100000000000", "585#600D100000000000"},
  });
  EXPECT_EQ(unit.says("605#2B171000E8030000"), (Lines{"585#6017100000000000", "705#7F"}));
  unit.expect_dialogue({
      {"605#2F0D100003000000", "585#800D100022000008"},
      {"605#2B0C1000C8000000", "585#800C100022000008"},
      {"605#2B0C100000000000", "585#600C100000000000"},
  });
}

TEST(Unit, IdentifiesItselfAsTheDriveUnit) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.upload(0x1000).number(), 0xFFFF0192);
  EXPECT_EQ(unit.upload(0x1001).number(), 0);
  EXPECT_EQ(unit.upload(0x1003).number(), 0);
  EXPECT_EQ(unit.upload(0x1005).number(), 0x80);
  EXPECT_EQ(unit.upload(0x1008).text(), "SINAMICS");
  EXPECT_EQ(unit.upload(0x100A).text(), "04.80.65.00");
  EXPECT_EQ(unit.upload(0x1014).number(), 0x85);
  EXPECT_EQ(unit.upload(0x1017).number(), 0);
  EXPECT_EQ(unit.upload(0x1018, 0).number(), 4);
  EXPECT_EQ(unit.upload(0x1018, 1).number(), 0x06000053);
  EXPECT_EQ(unit.upload(0x1018, 2).number(), 0x5000);
  EXPECT_EQ(unit.upload(0x6502).number(), 0x0000000E);
  EXPECT_EQ(unit.upload(0x6504).text(), "SIEMENS");
  EXPECT_EQ(unit.upload(0x67FF).number(), 0x00020192);
}

TEST(Unit, StartsWithThePredefinedIdentifiersOfItsNode) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.upload(0x1200, 1).number(), 0x605);
  EXPECT_EQ(unit.upload(0x1200, 2).number(), 0x585);
  EXPECT_EQ(unit.upload(0x1400, 1).number(), 0x205);
  EXPECT_EQ(unit.upload(0x1403, 1).number(), 0x505);
  EXPECT_EQ(unit.upload(0x1800, 1).number(), 0x40000185);
  EXPECT_EQ(unit.upload(0x1803, 1).number(), 0x40000485);
  std::vector<std::uint32_t> identifiers;
  for (const canopen::Subscription& wanted : unit.device.subscriptions())
    if (!wanted.remote) identifiers.push_back(wanted.identifier);
  EXPECT_EQ(identifiers,
            (std::vector<std::uint32_t>{0x000, 0x080, 0x205, 0x305, 0x405, 0x505, 0x585, 0x605, 0x705}));
}

TEST(Unit, TellsOfAnotherStationWithItsNodeId) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.says("705#00"), Lines{});
  EXPECT_EQ(unit.says("585#4300100092010200"), Lines{});

  EXPECT_EQ(unit.listener.foreign, (std::vector<std::uint32_t>{0x705, 0x585}));
}

TEST(Unit, SendsItsStateOnceAHeartbeatPeriod) {
  TestUnit unit;
  unit.start();

  EXPECT_EQ(unit.says("605#2B171000E8030000"), (Lines{"585#6017100000000000", "705#7F"}));
  EXPECT_EQ(unit.passes(3s), (Lines{"705#7F", "705#7F", "705#7F"}));
  unit.says("000#0205");
  EXPECT_EQ(unit.passes(1s), Lines{"705#04"});
}

}  // namespace
}  // namespace device
