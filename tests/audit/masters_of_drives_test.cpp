// What masters that lead drives do rightly, and an auditor may take for a mistake.
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/audit/heard_log.hpp"

namespace audit_test {
namespace {

using Rules = std::vector<std::string_view>;

Rules rules_in(std::string_view log) {
  return rules_of(findings_of(log));
}

/// A drive that is enabled in mode @p shown, which gets another one while its statusword is @p statusword.
std::string other_mode(const char* shown, const char* statusword) {
  return fmt::format(R"((0.0000) can0 605#4061600000000000
(0.0010) can0 585#4F616000{}000000
(0.0020) can0 605#4041600000000000
(0.0030) can0 585#4B416000{}0000
(0.0040) can0 605#2F60600004000000
(0.0050) can0 585#6060600000000000)",
                     shown, statusword);
}

TEST(ModeOfADrive, ChangesAtRest) {
  EXPECT_EQ(rules_in(other_mode("00", "3702")), Rules{});  // in no mode bit 10 means nothing
  EXPECT_EQ(rules_in(other_mode("03", "3712")), Rules{});  // speed is 0
  EXPECT_EQ(rules_in(other_mode("01", "3706")), Rules{});  // target reached
  EXPECT_EQ(rules_in(other_mode("06", "3712")), Rules{});  // homing attained
  EXPECT_EQ(rules_in(other_mode("08", "3712")), Rules{});  // bits do not tell whether it moves
}

TEST(ModeOfADrive, ChangesInMotion) {
  for (const char* const shown : {"01", "06"})
    EXPECT_EQ(rules_in(other_mode(shown, "3702")), Rules{"drive.mode-moving"}) << shown;
  EXPECT_EQ(rules_in(other_mode("03", "3706")), Rules{"drive.mode-moving"});
}

/// SYNC after each of @p pauses (ms).
std::string syncs(const std::vector<double>& pauses) {
  double at = 0;
  std::string log = "(0.000000) can0 080#\n";
  for (const double pause : pauses) log += fmt::format("({:.6f}) can0 080#\n", at += pause / 1000);
  return log;
}

TEST(Sync, GetsAnotherPeriod) {
  std::vector<double> pauses(10, 10);
  pauses.insert(pauses.end(), 10, 20);
  EXPECT_EQ(rules_in(syncs(pauses)), Rules{});
}

TEST(Sync, PausesAndGoesOn) {
  std::vector<double> pauses(10, 10);
  pauses.push_back(1500);
  pauses.insert(pauses.end(), 10, 10);
  EXPECT_EQ(rules_in(syncs(pauses)), Rules{});
}

TEST(Sync, ComesNowAndThen) {
  EXPECT_EQ(rules_in(syncs({700, 3, 1200, 40, 2, 2, 900, 5, 300, 1, 80, 2000, 7})), Rules{});
}

TEST(Sync, IsLateOnceAmongMany) {
  std::vector<double> pauses(10, 10);
  pauses.push_back(16);
  pauses.insert(pauses.end(), 10, 10);
  EXPECT_EQ(rules_in(syncs(pauses)), Rules{"sync.jitter"});
}

TEST(Lss, ConfiguresTheNodeThatAFastscanHasFound) {
  EXPECT_EQ(rules_in(R"((0.0000) can0 7E5#5100000000800000
(0.0010) can0 7E4#4F00000000000000
(0.0100) can0 7E5#5101000000000300
(0.0110) can0 7E4#4F00000000000000
(0.0200) can0 7E5#110B000000000000
(0.0210) can0 7E4#1100000000000000
(0.0300) can0 7E5#0400000000000000)"),
            Rules{});
}

TEST(Nmt, NodeRunsThatSendsPdos) {
  EXPECT_EQ(rules_in(R"((0.0000) can0 000#0105
(0.0010) can0 705#00
(0.0020) can0 185#3702
(0.0030) can0 205#0600)"),
            Rules{});
}

TEST(Controlword, GoesOverSdoAgainBehindThePdos) {
  EXPECT_EQ(rules_in(R"((0.0000) can0 605#2F00160000000000
(0.0001) can0 585#6000160000000000
(0.0002) can0 605#2300160110004060
(0.0003) can0 585#6000160100000000
(0.0004) can0 605#2F00160001000000
(0.0005) can0 585#6000160000000000
(0.0006) can0 605#2300140105020000
(0.0007) can0 585#6000140100000000
(0.0100) can0 205#0600
(0.0200) can0 000#8005
(0.0300) can0 605#2B40600006000000
(0.0310) can0 585#6040600000000000)"),
            Rules{});
}

/// Two bytes in TPDO 1 and RPDO 1 of node 5, as it is delivered.
eds::Description description_of_pdos() {
  eds::Description description{5};
  for (const std::uint16_t mapping : {std::uint16_t{0x1600}, std::uint16_t{0x1A00}}) {
    description.add(
        {.index = mapping, .type = eds::find_data_type(5), .initial = eds::Value{.integer = {.magnitude = 1}}});
    description.add({.index = mapping,
                     .sub_index = 1,
                     .type = eds::find_data_type(7),
                     .initial = eds::Value{.integer = {.magnitude = 0x60400010}}});
  }
  return description;
}

Rules rules_by_pdos(std::string_view log) {
  return rules_of(findings_of(log, {.descriptions = {description_of_pdos()}}));
}

TEST(Eds, TellsTheLengthOfPdos) {
  EXPECT_EQ(rules_by_pdos("(0.0) can0 705#00\n(0.1) can0 000#0105\n(0.2) can0 185#0102\n(0.3) can0 205#06000000"),
            Rules{"pdo.long"});
}

TEST(Eds, IsNotWhatANodeHasWhosePdosAreOthers) {
  EXPECT_EQ(
      rules_by_pdos("(0.0) can0 705#00\n(0.1) can0 000#0105\n(0.2) can0 185#01020304\n(0.3) can0 205#06000000"),
      Rules{});
}

TEST(Eds, IsNotWhatANodeHasThatWasConfiguredBefore) {
  EXPECT_EQ(rules_by_pdos("(0.0) can0 705#00\n(0.1) can0 605#4020100100000000\n(0.2) can0 585#43201001B0360000\n"
                          "(0.3) can0 000#0105\n(0.4) can0 185#0102\n(0.5) can0 205#060000000000"),
            Rules{});
}

/// 1017h (UNSIGNED16, 100 ms to 1 s) of node 5 is written with the command byte @p command and @p value.
Rules rules_of_write(const char* command, const char* value) {
  eds::Description description{5};
  description.add({.index = 0x1017,
                   .type = eds::find_data_type(6),
                   .low = eds::Value{.integer = {.magnitude = 100}},
                   .high = eds::Value{.integer = {.magnitude = 1000}}});
  const std::string log =
      fmt::format("(0.0) can0 605#{}171000{}\n(0.1) can0 585#6017100000000000", command, value);
  return rules_of(findings_of(log, {.descriptions = {description}}));
}

TEST(Eds, TellsTheLengthOfValues) {
  EXPECT_EQ(rules_of_write("2B", "64000000"), Rules{});
  EXPECT_EQ(rules_of_write("23", "64000000"), Rules{"object.length"});
}

TEST(Eds, TellsHowMuchCountsOfAValueWithoutASize) {
  EXPECT_EQ(rules_of_write("22", "64000000"), Rules{"sdo.size-untold"});
  EXPECT_EQ(rules_of_write("22", "E9030000"), (Rules{"sdo.size-untold", "object.limits"}));
}

TEST(Eds, TellsTheIdentifierOfATpdoThatWasNotHeard) {
  eds::Description description{6};
  description.add({.index = 0x1800,
                   .sub_index = 1,
                   .type = eds::find_data_type(7),
                   .initial = eds::Value{.integer = {.magnitude = 0x186}}});
  constexpr std::string_view kLog = R"((0.0) can0 705#00
(0.1) can0 706#00
(0.2) can0 605#2300180186010000
(0.3) can0 585#6000180100000000
(0.4) can0 000#0100)";
  EXPECT_EQ(rules_of(findings_of(kLog, {.descriptions = {description}})), Rules{"bus.identifier-twice"});
}

TEST(Controlword, IsOfTwoSourcesOnlyAsTimesTell) {
  constexpr std::string_view kLog = R"((0.0) can0 605#4000160000000000
(0.0) can0 585#4F00160001000000
(0.0) can0 605#4000160100000000
(0.0) can0 585#4300160110004060
(0.0) can0 705#05
(0.0) can0 205#0600
(0.0) can0 605#2B40600006000000
(0.0) can0 585#6040600000000000)";
  EXPECT_EQ(rules_of(findings_of(kLog, {.has_times = true})), Rules{"drive.two-sources"});
  EXPECT_EQ(rules_of(findings_of(kLog, {.has_times = false})), Rules{});
}

}  // namespace
}  // namespace audit_test
