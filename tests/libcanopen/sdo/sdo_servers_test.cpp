#include "tests/libcanopen/fixture/sdo_servers_fixture.hpp"

namespace {

TEST_F(SdoServers, AnswerUnderTheirOwnIdentifiers) {
  EXPECT_EQ(says("680#4000100000000000"), (Lines{"681#4300100092010200"}));
  EXPECT_EQ(says("605#4000100000000000"), (Lines{"585#4300100092010200"}));
  EXPECT_EQ(subscriptions(), (std::vector<std::uint32_t>{0x000, 0x205, 0x585, 0x605, 0x680, 0x705}));
}

TEST_F(SdoServers, WorkAsSoonAsBothIdentifiersAreValid) {
  EXPECT_EQ(writes_u32(0x1201, 1, 0x690), 0U);
  EXPECT_EQ(says("690#4000100000000000"), Lines{});
  EXPECT_EQ(writes_u32(0x1201, 2, 0x40000691), 0U);  // bit 30: assigned while running
  EXPECT_EQ(says("690#4000100000000000"), (Lines{"691#4300100092010200"}));

  EXPECT_EQ(writes_u32(0x1201, 2, 0x80000691), 0U);
  EXPECT_EQ(says("690#4000100000000000"), Lines{});
  EXPECT_EQ(application.subscription_changes, 3);  // start, on, off
}

TEST_F(SdoServers, KeepTheirIdentifiersWhileTheyAreValid) {
  EXPECT_EQ(writes_u32(0x1201, 1, 0x690), 0U);
  EXPECT_EQ(writes_u32(0x1201, 1, 0x690), 0U);
  EXPECT_EQ(writes_u32(0x1201, 1, 0x691), kDeviceState);
  EXPECT_EQ(writes_u32(0x1201, 1, 0x80000000), 0U);
  EXPECT_EQ(writes_u32(0x1201, 1, 0x691), 0U);
}

TEST_F(SdoServers, RefuseRestrictedAndStrayIdentifiers) {
  for (const std::uint32_t cob_id : {0x000U, 0x001U, 0x07FU, 0x101U, 0x180U, 0x581U, 0x5FFU, 0x601U, 0x67FU,
                                     0x6E0U, 0x6FFU, 0x701U, 0x7FFU, 0x800U, 0x10000690U, 0x20000690U}) {
    EXPECT_EQ(writes_u32(0x1201, 1, cob_id), kInvalidValue) << std::hex << cob_id;
    EXPECT_EQ(writes_u32(0x1201, 2, cob_id), kInvalidValue) << std::hex << cob_id;
  }
  EXPECT_EQ(value_of(0x1201, 1), 0x80000000);
}

TEST_F(SdoServers, RefuseIdentifiersOfOtherServices) {
  for (const std::uint32_t cob_id : {0x205U, 0x680U, 0x681U}) {
    EXPECT_EQ(writes_u32(0x1201, 1, cob_id), kIncompatible) << std::hex << cob_id;
    EXPECT_EQ(writes_u32(0x1201, 2, cob_id), kIncompatible) << std::hex << cob_id;
  }
  EXPECT_EQ(writes_u32(0x1201, 1, 0x690), 0U);
  EXPECT_EQ(writes_u32(0x1201, 2, 0x690), kIncompatible);  // its own other direction
}

TEST_F(SdoServers, RefuseToStartUnderAnIdentifierThatWasTakenInTheMeantime) {
  EXPECT_EQ(writes_u32(0x1201, 1, 0x690), 0U);
  EXPECT_EQ(writes_u32(0x1202, 1, 0x690), 0U);  // neither works yet
  EXPECT_EQ(writes_u32(0x1202, 2, 0x691), 0U);

  EXPECT_EQ(writes_u32(0x1201, 2, 0x692), kIncompatible);
  EXPECT_EQ(says("690#4000100000000000"), (Lines{"691#4300100092010200"}));
}

TEST_F(SdoServers, AnswerUnderTheOldIdentifierWhenTheyAreChangedThroughThemselves) {
  EXPECT_EQ(says("680#237F120200000080"), (Lines{"681#607F120200000000"}));
  EXPECT_EQ(says("680#4000100000000000"), Lines{});

  EXPECT_EQ(writes_u32(0x127F, 2, 0x691), 0U);
  says("680#217F120204000000");
  EXPECT_EQ(says("680#0700000080000000"), (Lines{"691#2000000000000000"}));  // in segments too
  EXPECT_EQ(says("680#4000100000000000"), Lines{});
  EXPECT_EQ(node->next_deadline(), canopen::kNever);
}

TEST_F(SdoServers, ForgetTheirTransferWhenTheyAreSwitchedOff) {
  says("680#2103210009000000");
  EXPECT_EQ(writes_u32(0x127F, 1, 0x80000680), 0U);
  EXPECT_EQ(writes_u32(0x127F, 1, 0x680), 0U);

  EXPECT_EQ(says("680#0001020304050607"), (Lines{"681#8000000001000405"}));
  EXPECT_EQ(passes(1min), Lines{});
}

TEST_F(SdoServers, HaveTheirInitialValuesAgainAfterAReset) {
  writes_u32(0x1201, 1, 0x690);
  writes_u32(0x1201, 2, 0x691);
  writes_u32(0x127F, 1, 0x80000680);
  says("000#8205");

  EXPECT_EQ(says("690#4000100000000000"), Lines{});
  EXPECT_EQ(says("680#4000100000000000"), (Lines{"681#4300100092010200"}));
}

/// Stores two servers under one identifier whenever the node is reset.
class CollidingServers : public SdoServers {
 protected:
  class Application final : public canopen::Application {
   public:
    explicit Application(canopen::Dictionary& dictionary) : dictionary_{dictionary} {}
    void on_reset(canopen::NmtCommand) noexcept override {
      set(0x1201, 1, 0x690);
      set(0x1201, 2, 0x691);
      set(0x1202, 1, 0x690);  // as that of 1201h
      set(0x1202, 2, 0x692);
      set(0x1203, 1, 0x612);  // restricted
      set(0x1203, 2, 0x693);
    }

   private:
    void set(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value) noexcept {
      dictionary_.set(*dictionary_.find(index, sub_index).value(), value);
    }
    canopen::Dictionary& dictionary_;
  } storing{dictionary};
  canopen::Node storing_node{dictionary, {.extended_identifiers = false}, bus, storing};
};

TEST_F(CollidingServers, AreFoundAfterAResetAndTheFirstOneWorks) {
  storing_node.start(now);
  storing_node.on_frame(fakes::frame_of("000#8205"), now);
  bus.take();
  for (const char* const request : {"690#4000100000000000", "612#4000100000000000", "605#4000100000000000"}) {
    storing_node.on_frame(fakes::frame_of(request), now);
  }
  EXPECT_EQ(sent(), (Lines{"691#4300100092010200", "585#4300100092010200"}));
}

TEST_F(SdoServers, ThatCannotWorkWithWhatIsStoredAreShownAsInvalid) {
  store_ids(0x1201, 0x690, 0x691);
  store_ids(0x1202, 0x690, 0x692);  // as that of 1201h
  store_ids(0x1203, 0x612, 0x693);  // restricted
  start();
  EXPECT_EQ(value_of(0x1201, 1), 0x690);
  EXPECT_EQ(value_of(0x1202, 1), 0x80000690);
  EXPECT_EQ(value_of(0x1202, 2), 0x80000692);
  EXPECT_EQ(value_of(0x1203, 1), 0x80000612);

  EXPECT_EQ(writes_u32(0x1202, 2, 0x692), 0U);
  EXPECT_EQ(writes_u32(0x1202, 1, 0x690), kIncompatible);
  EXPECT_EQ(writes_u32(0x1203, 2, 0x693), 0U);
  EXPECT_EQ(says("690#4000100000000000"), (Lines{"691#4300100092010200"}));
  EXPECT_EQ(says("612#4000100000000000"), Lines{});

  EXPECT_EQ(writes_u32(0x1202, 1, 0x694), 0U);
  EXPECT_EQ(says("694#4000100000000000"), (Lines{"692#4300100092010200"}));
}

TEST_F(SdoServers, OfWhichOneIdentifierIsStoredKeepItIfTheyMay) {
  store_ids(0x1201, 0x612, 0x80000000);  // restricted
  store_ids(0x1202, 0x690, 0x80000000);
  start();

  EXPECT_EQ(writes_u32(0x1201, 2, 0x693), 0U);
  EXPECT_EQ(says("612#4000100000000000"), Lines{});
  EXPECT_EQ(writes_u32(0x1202, 2, 0x691), 0U);
  EXPECT_EQ(says("690#4000100000000000"), (Lines{"691#4300100092010200"}));
}

/// 128 servers, all but the first one under identifiers of 29 bits.
class ManySdoServers : public NodeTest {
 protected:
  ManySdoServers() : NodeTest{{}, many_servers_table()} { start(); }
  static std::string request(unsigned n, std::string_view data) {
    char identifier[16];
    std::snprintf(identifier, sizeof identifier, n == 0 ? "605#" : "%08X#", n);
    return identifier + std::string{data};
  }
  static std::string answer(unsigned n, std::string_view data) {
    char identifier[16];
    std::snprintf(identifier, sizeof identifier, n == 0 ? "585#" : "%08X#", 0x1000 + n);
    return identifier + std::string{data};
  }
  /// Says @p format to server @p n, with n in the place of %02X; it answers @p expected likewise, "" for silence.
  void expect_answer(unsigned n, const char* format, const char* expected) {
    char said[32], answered[32];
    std::snprintf(said, sizeof said, format, n);
    std::snprintf(answered, sizeof answered, expected, n);
    const Lines lines = *answered != '\0' ? Lines{answer(n, answered)} : Lines{};
    ASSERT_EQ(says(request(n, said)), lines) << n;
  }
  /// The same to every server, one after the other.
  void expect_answers(const char* format, const char* expected) {
    for (unsigned n = 0; n < kServers; ++n) ASSERT_NO_FATAL_FAILURE(expect_answer(n, format, expected));
  }
  static constexpr unsigned kServers = 128;
};

TEST_F(ManySdoServers, KeepTheirTransfersApart) {
  expect_answers("21%02X220009000000", "60%02X220000000000");
  expect_answers("00%02X020304050607", "2000000000000000");
  expect_answers("1B%02X090000000000", "3000000000000000");

  expect_answers("40%02X220000000000", "41%02X220009000000");
  expect_answers("6000000000000000", "00%02X020304050607");
  expect_answers("7000000000000000", "1B%02X090000000000");

  expect_answers("A4%02X220001000000", "C6%02X220009000000");
  expect_answers("A300000000000000", "01%02X020304050607");
  expect_answers("A201010000000000", "81%02X090000000000");
}

TEST_F(ManySdoServers, ServeTransfersOfEveryKindAtTheSameTime) {
  using Step = std::array<const char*, 2>;
  static constexpr std::array<std::array<Step, 3>, 4> kKinds{{
      {{{"21%02X220007000000", "60%02X220000000000"},
        {"01%02X020304050607", "2000000000000000"},
        {"40%02X220000000000", "41%02X220007000000"}}},
      {{{"40%02X220000000000", "41%02X220000000000"},
        {"6000000000000000", "0F00000000000000"},
        {"4000200000000000", "4300200000000000"}}},
      {{{"C2%02X220007000000", "A4%02X22007F000000"},
        {"81%02X020304050607", "A2017F0000000000"},
        {"C100000000000000", "A100000000000000"}}},
      {{{"23%02X220041424344", "60%02X220000000000"},
        {"A4%02X22007F000000", "C6%02X220004000000"},
        {"A300000000000000", "8141424344000000"}}},
  }};
  for (std::size_t step = 0; step < 3; ++step) {
    for (unsigned n = 0; n < kServers; ++n) {
      const auto& [said, answered] = kKinds[n % kKinds.size()][step];
      ASSERT_NO_FATAL_FAILURE(expect_answer(n, said, answered));
    }
  }
}

TEST_F(ManySdoServers, TimeOutEachOnItsOwn) {
  for (unsigned n = 0; n < kServers; ++n) {
    expect_answer(n, "21%02X220009000000", "60%02X220000000000");
    now += 1ms;
  }
  EXPECT_EQ(passes(10s - 1ms - kServers * 1ms), Lines{});
  EXPECT_EQ(passes(1ms), (Lines{"10000ms 585#8000220000000405"}));
  EXPECT_EQ(passes(1min).size(), kServers - 1);
}

}  // namespace
