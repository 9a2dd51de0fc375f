#include "record/format.hpp"
#include "tests/fakes/recording_bytes.hpp"
#include "tests/tools/canopen-audit/audit_run.hpp"

namespace audit_tool_test {
namespace {

using CanopenAuditLog = AuditRun;

TEST_F(CanopenAuditLog, IsJudgedWithoutItsDamagedLines) {
  const fakes::Finished finished =
      audit("(1.0) can0 605#4000100000000000\n(1.1) can0 58\n(1.2) can0 585#4300100092010200\n");
  EXPECT_EQ(finished.status, 0) << finished.errors;
  EXPECT_NE(finished.output.find("remark   x.log:2: expected "), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("got \"(1.1) can0 58\": left out, a finding may come of that\n"),
            std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("x.log: 2 frames in 0.200 s: no rule is broken\n"), std::string::npos)
      << finished.output;
}

TEST_F(CanopenAuditLog, TellsSomeOfManyDamagedLines) {
  std::string log = kRight;
  for (int i = 0; i < 100; ++i) log += "damaged\n";
  const fakes::Finished finished = audit(log);
  EXPECT_NE(finished.output.find("x.log:7: "), std::string::npos) << finished.output;
  EXPECT_EQ(finished.output.find("x.log:8: "), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("remark   x.log: 100 damaged lines in all\n"), std::string::npos)
      << finished.output;
}

TEST_F(CanopenAuditLog, WithoutAnyFrameEndsWith3) {
  for (const std::string& text : {std::string{}, std::string{"\n \n"}}) {
    const fakes::Finished finished = audit(text);
    EXPECT_EQ(finished.status, 3);
    EXPECT_EQ(finished.errors, "canopen-audit: x.log: there is no frame in it\n");
    EXPECT_EQ(finished.output, "");
  }
}

TEST_F(CanopenAuditLog, OfRandomBytesEndsWith3AndSaysWhatWasExpected) {
  std::string text;
  for (unsigned i = 0, state = 1; i < 100'000; ++i) {
    state = state * 1'103'515'245 + 12'345;
    text += static_cast<char>(state >> 16);
  }
  const fakes::Finished finished = audit(text);
  EXPECT_EQ(finished.status, 3);
  EXPECT_TRUE(finished.errors.ends_with("canopen-audit: x.log: there is no frame in it\n")) << finished.errors;
  EXPECT_NE(finished.errors.find("x.log:1: expected "), std::string::npos) << finished.errors;
  EXPECT_EQ(finished.errors.find('\x1B'), std::string::npos);
}

TEST_F(CanopenAuditLog, OfTwoInterfacesIsRefusedUnlessOneIsMeant) {
  constexpr const char* kTwo = "(1.0) can0 605#4000100000000000\n(1.1) can1 605#4001100000000000\n";
  const fakes::Finished finished = audit(kTwo);
  EXPECT_EQ(finished.status, 2);
  EXPECT_EQ(finished.output, "");
  EXPECT_EQ(finished.errors,
            "canopen-audit: x.log:2: expected the interface can0 of the lines before, unless --of names one, got "
            "\"(1.1) can1 605#4001100000000000\"\n");
  EXPECT_NE(audit(kTwo, {"--of", "can1"}).output.find("x.log: 1 frames"), std::string::npos);
  EXPECT_EQ(audit(kTwo, {"--of", "can2"}).status, 3);
}

TEST_F(CanopenAuditLog, WithAGapIsSaidToHaveOne) {
  const fakes::Finished finished = audit(
      "(1.0) can0 605#4000100000000000\n(1.1) can0 585#4300100092010200\n"
      "(61.1) can0 605#4000100000000000\n(61.2) can0 585#4300100092010200\n"
      "(65.0) can0 605#4000100000000000\n(65.1) can0 585#4300100092010200\n");
  EXPECT_NE(finished.output.find("remark   x.log:3: no frame for 60.000 s before here, the longest of 2 gaps: a "
                                 "finding may come of frames that are missing\n"),
            std::string::npos)
      << finished.output;
}

TEST_F(CanopenAuditLog, WhoseTimeGoesBackIsJudgedByTheTimesBehind) {
  const fakes::Finished finished = audit(
      "(9.0) can0 605#4000100000000000\n(1.0) can0 585#4300100092010200\n"
      "(1.5) can0 605#4000100000000000\n(1.6) can0 605#4001100000000000\n");
  EXPECT_NE(finished.output.find("remark   x.log:2: the time goes back here: times are counted on from the frame "
                                 "before\n"),
            std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("      line 4: (0.600000) 605#4001100000000000  "), std::string::npos)
      << finished.output;
  EXPECT_TRUE(finished.output.ends_with("x.log: 4 frames in 0.600 s: errors 0, warnings 1\n")) << finished.output;
}

TEST_F(CanopenAuditLog, HasFramesThatLieALittleInTheWrongOrderPutRight) {
  EXPECT_EQ(audit("(1.0004) can0 585#4300100092010200\n(1.0) can0 605#4000100000000000\n", {"--strict"}).output,
            "x.log: 2 frames in 0.000 s: no rule is broken\n");
}

TEST_F(CanopenAuditLog, WithoutTimesIsJudgedWithoutRulesOfTime) {
  const fakes::Finished finished =
      audit("can0  605   [8]  40 00 10 00 00 00 00 00\ncan0  605   [8]  40 01 10 00 00 00 00 00\n", {"--strict"});
  EXPECT_EQ(finished.status, 1);
  EXPECT_NE(finished.output.find("warning  sdo.unaborted "), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("remark   x.log: the log has no time stamps: rules of time are not judged\n"),
            std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("      line 2: 605#4001100000000000  SDO request to node 5: "), std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("x.log: 2 frames: errors 0, warnings 1\n"), std::string::npos) << finished.output;
}

TEST_F(CanopenAuditLog, ThatIsCutWithinItsLastLineIsSaidToBe) {
  const fakes::Finished finished = audit(std::string{kRight} + "(1.2) can0 60");
  EXPECT_EQ(finished.status, 0);
  EXPECT_NE(finished.output.find("remark   x.log:3: the log is cut within its last line, which is left out\n"),
            std::string::npos)
      << finished.output;
}

TEST_F(CanopenAuditLog, OfARecordingWithLostRecordsSaysHowMany) {
  fakes::RecordingBytes recording{R"({"wall_clock_ns": 1000000000})"};
  const canopen::Frame request{.id = 0x605, .length = 8, .data = {0x40, 0x00, 0x10}};
  recording.add(record::frame_record(request, false, std::chrono::milliseconds{5}).bytes());
  recording.add(record::lost_record(12, std::chrono::milliseconds{6}).bytes());
  recording.add(record::frame_record(request, false, std::chrono::milliseconds{7}).bytes());
  const fakes::Finished finished = audit(recording.bytes());
  EXPECT_EQ(finished.status, 1) << finished.errors;
  EXPECT_NE(finished.output.find("remark   x.log: 12 records are missing: a finding may come of that\n"),
            std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("      record 3: (0.002000) 605#"), std::string::npos) << finished.output;
}

TEST_F(CanopenAuditLog, OfADamagedRecordingIsRefused) {
  const fakes::Finished finished = audit(std::string{record::kMagic} + "\x01");
  EXPECT_EQ(finished.status, 2);
  EXPECT_TRUE(finished.errors.starts_with("canopen-audit: x.log: ")) << finished.errors;
}

}  // namespace
}  // namespace audit_tool_test
