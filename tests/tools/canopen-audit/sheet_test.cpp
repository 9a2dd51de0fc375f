#include "tests/tools/canopen-audit/audit_run.hpp"

namespace audit_tool_test {
namespace {

constexpr const char* kSheet = R"([FileInfo]
FileName=x.eds

[DeviceInfo]
VendorName=x

[MandatoryObjects]
SupportedObjects=2
1=0x1000
2=0x1001

[1000]
ParameterName=Device type
ObjectType=0x7
DataType=0x0007
AccessType=ro
DefaultValue=0x00020192
PDOMapping=0

[1001]
ParameterName=Error register
ObjectType=0x7
DataType=0x0005
AccessType=ro
PDOMapping=0
)";

/// With an EDS that may be that of another device.
class CanopenAuditSheet : public AuditRun {
 protected:
  std::string remarks_of(std::string_view log, const char* node = "5") const {
    const fakes::Finished finished = audit(log, {"--eds", std::string{node} + ":" + write("x.eds", kSheet)});
    EXPECT_EQ(finished.errors, "");
    return finished.output.substr(0, finished.output.find("\n\n"));
  }
};

TEST_F(CanopenAuditSheet, ThatFitsIsNotSpokenOf) {
  EXPECT_EQ(remarks_of(kRight), "x.log: 2 frames in 0.001 s: no rule is broken\n");
}

TEST_F(CanopenAuditSheet, OfAnotherDeviceIsSaid) {
  EXPECT_EQ(
      remarks_of("(1.0) can0 605#4000100000000000\n(1.1) can0 585#4300100091010F00\n"),
      "remark   node 5: 1000h:00 (Device type) is 000F0191h, and 00020192h in its EDS: the EDS is of another "
      "device");
}

TEST_F(CanopenAuditSheet, WithAnObjectThatTheDeviceDoesNotHaveIsSaid) {
  EXPECT_EQ(remarks_of("(1.0) can0 605#4001100000000000\n(1.1) can0 585#8001100000000206\n"),
            "remark   node 5: it does not have 1001h:00 (Error register), which its EDS has: the EDS may be of "
            "another device");
}

TEST_F(CanopenAuditSheet, OfANodeThatIsNotThereIsSaid) {
  EXPECT_EQ(remarks_of(kRight, "7"), "remark   node 7: there is an EDS of it, and no frame");
}

TEST_F(CanopenAuditSheet, GivesNamesToObjects) {
  const fakes::Finished finished = audit(kOverlap, {"--eds", "5:" + write("x.eds", kSheet)});
  EXPECT_NE(finished.output.find("SDO request to node 5: read 1001h:00 (Error register)\n"), std::string::npos)
      << finished.output;
}

}  // namespace
}  // namespace audit_tool_test
