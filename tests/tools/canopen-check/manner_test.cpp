#include <algorithm>

#include <gtest/gtest.h>

#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tools/canopen-zoo/slave/defects.hpp"

/// Slaves with manners that CiA 301 allows or is silent about, and what one thing that is wrong leaves untested.
namespace conformance_test {
namespace {

using canopen::Frame;
using canopen::NmtCommand;
using conformance::CheckResult;
using conformance::Outcome;
using conformance::RunReport;

const CheckResult& result_of(const RunReport& report, std::string_view id) {
  return *std::ranges::find(report.results, id, [](const CheckResult& each) { return each.check->id; });
}

/// Simulated time that the checks of @p report took whose ids begin with @p begin.
canopen::Duration time_of(const RunReport& report, std::string_view begin) {
  canopen::Duration time{};
  for (const CheckResult& each : report.results)
    if (each.check->id.starts_with(begin)) time += each.time;
  return time;
}

bool has_note(const RunReport& report, std::string_view text) {
  const auto tells = [&](const std::string& note) { return note.find(text) != std::string::npos; };
  return std::ranges::any_of(report.notes, tells) ||
         std::ranges::any_of(report.results,
                             [&](const CheckResult& each) { return std::ranges::any_of(each.notes, tells); });
}

/// Before every answer about 1018h comes an abort of something else, as a slave sends that gives up a former
/// transfer.
TEST(Manners, LateAbortsAreNoAnswers) {
  const RunReport report = run_checks({.incoming = [](Slave& slave, Frame& frame) {
    if (frame.id == kRequestOf5 && frame.data[0] == 0x40 && frame.data[1] == 0x18 && frame.data[2] == 0x10)
      slave.say({.id = kResponseOf5, .length = 8, .data = {0x80, 0, 0, 0, 0, 0, 0, 8}});
    return true;
  }});
  EXPECT_EQ(findings_of(report), "");
  EXPECT_TRUE(has_note(report, "585#8000000000000008 while 605#4018100100000000 was asked"));
}

TEST(Manners, AbortsThatAnswerAbortsOfTheClientAreFoundWhereTheyAreLookedFor) {
  const RunReport report = run_checks({.incoming = [](Slave& slave, Frame& frame) {
    if (frame.id != kRequestOf5 || frame.data[0] != 0x80) return true;
    Frame echo = frame;
    echo.id = kResponseOf5;
    slave.say(echo);
    return true;
  }});
  EXPECT_EQ(failed_checks(report),
            (std::set<std::string>{"sdo.block-abort", "sdo.block-download-abort", "sdo.client-abort"}))
      << findings_of(report);
}

TEST(Manners, ObeyingLongCommandsIsNoted) {
  const RunReport report = run_checks({.incoming =
                                           [](Slave&, Frame& frame) {
                                             if (frame.id == 0 && frame.length > 2) frame.length = 2;
                                             return true;
                                           }},
                                      "nmt.");
  EXPECT_EQ(findings_of(report), "");
  EXPECT_TRUE(has_note(report, "a Stop of 8 bytes is obeyed"));
}

TEST(Manners, AnsweringShortRequestsIsNoted) {
  const RunReport report = run_checks({.incoming =
                                           [](Slave&, Frame& frame) {
                                             if (frame.id == kRequestOf5 && !frame.remote && frame.length < 8)
                                               frame.length = 8;
                                             return true;
                                           }},
                                      "sdo.short-request");
  EXPECT_EQ(findings_of(report), "");
  EXPECT_TRUE(has_note(report, "requests of 0, 1, 2, 3, 4, 5, 6, 7 bytes are answered"));
}

/// A slave that does not enter Operational because of an error that it shows.
Defect with_pending_error() {
  return {.table =
              [](auto& table) {
                row(table, 0x1003, 0).initial = 1;
                row(table, 0x1003, 1).initial = 0x5000;
              },
          .incoming = [](Slave&, Frame& frame) { return !is_command(frame, NmtCommand::Start); },
          .outgoing =
              [](Slave& slave, Frame& frame) {
                if (shows(slave, frame, 0x1001)) frame.data[4] = 1;
                return true;
              }};
}

TEST(Preconditions, ARefusalOfOperationalIsOneFindingWithItsReason) {
  const RunReport report = run_checks(with_pending_error(), "nmt.");
  EXPECT_EQ(failed_checks(report), std::set<std::string>{"nmt.operational"}) << findings_of(report);
  const std::string reason = result_of(report, "nmt.transitions").reason;
  EXPECT_TRUE(reason.starts_with("the slave refuses Operational: it is in Pre-operational")) << reason;
  EXPECT_NE(reason.find("1001h = 01h"), std::string::npos) << reason;
}

TEST(Preconditions, WhatNeedsOperationalIsSkippedWithoutTheCheckOfItToo) {
  const RunReport report = run_checks(with_pending_error(), "pdo.");
  EXPECT_EQ(findings_of(report), "");
  EXPECT_TRUE(
      result_of(report, "pdo.parameters-in-operational").reason.starts_with("the slave refuses Operational"));
}

TEST(Preconditions, ANodeThatEndsOnResetIsSaidToBeGoneOnce) {
  const RunReport report = run_checks(
      hangs_on([](const Slave&, const Frame& frame) { return is_command(frame, NmtCommand::ResetNode); }, false),
      "nmt.");
  EXPECT_EQ(failed_checks(report), std::set<std::string>{"nmt.boot-up-after-reset-node"}) << findings_of(report);
  EXPECT_EQ(report.problem, "the node is gone since nmt.boot-up-after-reset-node");
  EXPECT_TRUE(report.cut_short);
  EXPECT_EQ(report.count(Outcome::Skipped), report.results.size() - 1);
  EXPECT_EQ(report.count(Outcome::Broken), 0U);
}

TEST(Preconditions, WithoutResetsNoneIsSentAndNothingElseIsFound) {
  bool reset = false;
  conformance::Settings settings = full_settings();
  settings.allow_reset = false;
  const RunReport report = run_checks({.incoming =
                                           [&](Slave&, Frame& frame) {
                                             reset = reset || is_command(frame, NmtCommand::ResetNode) ||
                                                     is_command(frame, NmtCommand::ResetCommunication);
                                             return true;
                                           }},
                                      {}, settings);
  EXPECT_FALSE(reset);
  EXPECT_EQ(findings_of(report), "");
  EXPECT_EQ(result_of(report, "nmt.boot-up-once").reason, "it resets the node, which --no-reset forbids");
  EXPECT_GT(report.count(Outcome::Passed), report.count(Outcome::Skipped));
}

TEST(Preconditions, WhatTheUserLeavesOutIsSkipped) {
  conformance::Settings settings = full_settings();
  settings.skip = {"nmt.boot-up-once", "sdo"};
  const RunReport report = run_checks({}, {}, settings);
  EXPECT_EQ(result_of(report, "nmt.boot-up-once").reason, "left out by --skip");
  EXPECT_EQ(result_of(report, "sdo.toggle-bit").outcome, Outcome::Skipped);
  EXPECT_EQ(result_of(report, "nmt.boot-up-after-reset-node").outcome, Outcome::Passed);
}

TEST(Preconditions, ACrashIsToldAtOnceWithTheWriteThatCausedIt) {
  constexpr canopen::Duration kSoon = std::chrono::seconds{6};
  const RunReport report = run_checks(
      hangs_on([](const Slave& slave,
                  const Frame& frame) { return writes(slave, frame, 0x1016, 1) && value_of(frame) == 0; },
               false),
      "error-control.consumer");
  EXPECT_EQ(failed_checks(report).size(), 1U) << findings_of(report);
  EXPECT_NE(
      findings_of(report).find("1016h:01: expected the node behind the check, found no answer to SDO requests: it "
                               "is gone since writing 1016h:01, 605#2316100100000000"),
      std::string::npos)
      << findings_of(report);
  EXPECT_LT(time_of(report, "error-control.consumer"), kSoon);
}

TEST(Preconditions, ASilentBootUpIsWaitedForOnce) {
  const RunReport report =
      run_checks({.outgoing =
                      [](Slave&, Frame& frame) {
                        return !(frame.id == kErrorControlOf5 && frame.length == 1 && frame.data[0] == 0);
                      }},
                 "nmt.boot-up");
  EXPECT_LT(time_of(report, "nmt.boot-up"), std::chrono::seconds{13});
  EXPECT_EQ(result_of(report, "nmt.boot-up-once").reason, "the node sends no boot-up message");
}

TEST(Preconditions, EmergencyMessagesThatNeverComeAreWaitedForOnce) {
  const RunReport report =
      run_checks({.outgoing = [](Slave&, Frame& frame) { return frame.id != kEmcyOf5; }}, "emcy.");
  EXPECT_EQ(findings_of(report), "");
  EXPECT_LT(time_of(report, "emcy."), std::chrono::seconds{5});
}

/// Takes the objects of emergency messages from @p table.
void remove_emcy(std::vector<canopen::EntryDescription>& table) {
  std::erase_if(table, [](const auto& entry) { return entry.index == 0x1014 || entry.index == 0x1015; });
}

/// A slave without 1014h, whose emergency messages come or do not.
Defect without_emcy(bool sends) {
  return {.table = remove_emcy,
          .eds =
              [](std::string& eds) {
                std::vector<canopen::EntryDescription> table = right_objects();
                remove_emcy(table);
                eds = eds_of(table);
              },
          .outgoing = [sends](Slave&, Frame& frame) { return sends || frame.id != kEmcyOf5; }};
}

TEST(Manners, NobodyWithoutEmergencyMessagesIsBlamedForNone) {
  EXPECT_EQ(findings_of(run_checks(without_emcy(false))), "");
}

TEST(Manners, NobodyIsBlamedForEmergencyMessagesWithoutTheirObject) {
  EXPECT_EQ(findings_of(run_checks(without_emcy(true))), "");
}

/// True for communication parameters of PDOs.
bool has_pdo_parameters(std::uint16_t index) {
  const unsigned area = index & 0xFFF0U;
  return area == 0x1400 || area == 0x1800;
}

/// Makes the transmission types of all PDOs constants.
void fix_types(std::vector<canopen::EntryDescription>& table) {
  for (canopen::EntryDescription& entry : table)
    if (has_pdo_parameters(entry.index) && entry.sub_index == 2)
      entry.access = entry.index < 0x1800 ? canopen::Access::Constant : canopen::Access::ReadOnly;
}

TEST(Manners, ATransmissionTypeThatTheEdsCallsConstantIsLeftAlone) {
  const RunReport report = run_checks({.table = fix_types,
                                       .eds =
                                           [](std::string& eds) {
                                             std::vector<canopen::EntryDescription> table = right_objects();
                                             fix_types(table);
                                             eds = eds_of(table);
                                           }},
                                      "pdo.");
  EXPECT_EQ(findings_of(report), "");
  EXPECT_EQ(result_of(report, "pdo.transmission-types").reason, "the EDS calls no transmission type writable");
}

/// Empties every mapping and makes every PDO invalid.
void empty_mappings(std::vector<canopen::EntryDescription>& table) {
  for (canopen::EntryDescription& entry : table) {
    const unsigned area = entry.index & 0xFFF0U;
    if ((area == 0x1600 || area == 0x1A00) && entry.sub_index == 0) entry.initial = 0;
    if ((area == 0x1400 || area == 0x1800) && entry.sub_index == 1) entry.initial |= 0x80000000;
  }
}

TEST(Manners, APdoThatMapsNothingNeedNotBeEnabled) {
  const RunReport report =
      run_checks({.table = empty_mappings,
                  .eds =
                      [](std::string& eds) {
                        std::vector<canopen::EntryDescription> table = right_objects();
                        empty_mappings(table);
                        eds = eds_of(table);
                      },
                  .incoming =
                      [](Slave& slave, Frame& frame) {
                        const auto index = static_cast<std::uint16_t>(frame.data[1] | frame.data[2] << 8U);
                        const bool cob_id = has_pdo_parameters(index) && writes(slave, frame, index, 1);
                        if (!cob_id || (value_of(frame) & 0x80000000U) != 0) return true;
                        if (stored(slave, static_cast<std::uint16_t>(index + 0x200)) != 0) return true;
                        refuse(slave, frame, 0x06090030);
                        return false;
                      }},
                 "pdo.");
  EXPECT_EQ(findings_of(report), "");
  EXPECT_TRUE(has_note(report, "which maps nothing, cannot be enabled"));
}

TEST(Evidence, OfAnNmtCheckHoldsTheCommand) {
  const RunReport report = run_checks(
      {.incoming =
           [](Slave& slave, Frame& frame) {
             return !(is_command(frame, NmtCommand::Start) && slave.node().state() == canopen::NmtState::Stopped);
           }},
      "nmt.transitions");
  const CheckResult& result = result_of(report, "nmt.transitions");
  ASSERT_EQ(result.findings.size(), 1U);
  EXPECT_TRUE(std::ranges::any_of(result.findings.front().frames, [](const conformance::TimedFrame& each) {
    return each.sent && is_command(each.frame, NmtCommand::Start);
  }));
}

}  // namespace
}  // namespace conformance_test
