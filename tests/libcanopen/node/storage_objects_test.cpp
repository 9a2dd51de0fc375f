#include "tests/libcanopen/fixture/service_fixture.hpp"

namespace {

using canopen::AbortCode;

using StorageObjects = ServiceTest;

TEST_F(StorageObjects, StoreTheirGroupWhenSaveIsWritten) {
  start();
  told();

  expect_dialogue({
      {"605#2310100173617665", "585#6010100100000000"},
      {"605#2310100273617665", "585#6010100200000000"},
  });

  EXPECT_EQ(told(), (Lines{"store 1", "store 2"}));
}

TEST_F(StorageObjects, RestoreTheirGroupWhenLoadIsWritten) {
  start();
  told();

  expect_dialogue({
      {"605#231110016C6F6164", "585#6011100100000000"},
      {"605#231110026C6F6164", "585#6011100200000000"},
  });

  EXPECT_EQ(told(), (Lines{"restore 1", "restore 2"}));
}

TEST_F(StorageObjects, KeepReadingTheirCapabilities) {
  start();

  expect_dialogue({
      {"605#4010100100000000", "585#4310100103000000"},
      {"605#2310100173617665", "585#6010100100000000"},
      {"605#4010100100000000", "585#4310100103000000"},
      {"605#4011100100000000", "585#4311100101000000"},
      {"605#231110016C6F6164", "585#6011100100000000"},
      {"605#4011100100000000", "585#4311100101000000"},
      {"605#4010100000000000", "585#4F10100002000000"},
  });
}

TEST_F(StorageObjects, RefuseEveryOtherSignature) {
  start();
  told();

  for (const std::uint32_t value : {0U, 0x64616F6CU /* "load" */, 0x73617665U /* "evas" */, 0xFFFFFFFFU}) {
    EXPECT_EQ(writes_u32(0x1010, 1, value), 0x08000020U) << std::hex << value;
  }
  for (const std::uint32_t value : {0U, 0x65766173U /* "save" */, 0x6C6F6164U /* "daol" */, 1U}) {
    EXPECT_EQ(writes_u32(0x1011, 1, value), 0x08000020U) << std::hex << value;
  }

  EXPECT_EQ(told(), Lines{});
  EXPECT_EQ(value_of(0x1010, 1), 3);
  EXPECT_EQ(value_of(0x1011, 1), 1);
}

TEST_F(StorageObjects, TakeFourBytesOnly) {
  start();

  EXPECT_EQ(writes_u16(0x1010, 1, 0x6173), 0x06070010U);
  EXPECT_EQ(writes_u8(0x1010, 0, 2), 0x06010002U);
}

TEST_F(StorageObjects, AnswerWithTheRefusalOfTheApplication) {
  start();
  application.storage_answer = canopen::refuse(AbortCode::HardwareError);

  EXPECT_EQ(writes_u32(0x1010, 1, 0x65766173), 0x06060000U);
  EXPECT_EQ(writes_u32(0x1011, 1, 0x64616F6C), 0x06060000U);

  application.storage_answer = canopen::refuse(AbortCode::DeviceState);
  EXPECT_EQ(writes_u32(0x1010, 1, 0x65766173), 0x08000022U);
  EXPECT_EQ(value_of(0x1010, 1), 3);
}

TEST_F(StorageObjects, AnswerLaterIfTheApplicationWantsThat) {
  start();
  application.deferring = &*node;
  expect_dialogue({{"605#2310100173617665", ""}, {"605#2310100173617665", ""}});
  told();

  node->answer_deferred({}, now);

  EXPECT_EQ(sent(), Lines{"585#6010100100000000"});
  EXPECT_EQ(told(), Lines{}) << "the same request again is no other one";
  node->answer_deferred({}, now);
  EXPECT_EQ(sent(), Lines{});
}

TEST_F(StorageObjects, AnswerLaterWithARefusal) {
  start();
  application.deferring = &*node;
  expect_dialogue({{"605#2110100104000000", "585#6010100100000000"}, {"605#0773617665000000", ""}});

  node->answer_deferred(canopen::refuse(AbortCode::HardwareError), now);

  EXPECT_EQ(sent(), Lines{"585#8010100100000606"});
}

TEST_F(StorageObjects, GiveAnAnswerUpThatIsNotWaitedFor) {
  for (const char* const other : {"605#4010100100000000", "605#8010100100000405", "000#8205"}) {
    start();
    application.deferring = &*node;
    expect_dialogue({{"605#2310100173617665", ""}});
    says(other);

    node->answer_deferred({}, now);

    EXPECT_EQ(sent(), Lines{}) << other;
  }
}

TEST(StorageObjectsOfASimpleApplication, AnswerThatNothingCanBeStored) {
  fakes::VectorBus bus;
  canopen::Application application;
  canopen::Dictionary dictionary{service_table(), 5};
  canopen::Node node{dictionary, {}, bus, application};
  node.start(canopen::TimePoint{1h});

  for (const std::string signature : {"605#2310100173617665", "605#231110016C6F6164"}) {
    bus.take();
    node.on_frame(fakes::frame_of(signature), canopen::TimePoint{1h});
    ASSERT_EQ(bus.sent.size(), 1U);
    EXPECT_EQ(fakes::candump(bus.sent[0]), "585#80" + signature.substr(6, 6) + "00000606");
  }
}

}  // namespace
