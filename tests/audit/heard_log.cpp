#include "tests/audit/heard_log.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "can/port/wire.hpp"
#include "record/candump.hpp"

namespace audit_test {

std::vector<audit::Heard> frames_of(std::string_view log) {
  std::vector<audit::Heard> frames;
  std::istringstream lines{std::string{log}};
  std::uint64_t place = 0;
  for (std::string line; std::getline(lines, line);) {
    ++place;
    const auto read = record::read_candump_line(line);
    EXPECT_TRUE(read) << line;
    if (!read) continue;
    audit::Heard heard{.frame = bus::from_wire(read->frame), .at = read->at, .place = place};
    heard.is_error = (read->frame.can_id & CAN_ERR_FLAG) != 0;
    frames.push_back(heard);
  }
  return frames;
}

audit::Findings findings_of(std::string_view log, audit::Circumstances circumstances) {
  audit::Auditor auditor{std::move(circumstances)};
  for (const audit::Heard& heard : frames_of(log)) auditor.take(heard);
  auditor.end();
  return auditor.findings();
}

std::vector<std::string_view> rules_of(const audit::Findings& findings) {
  std::vector<std::string_view> ids;
  for (const audit::Finding& finding : findings.kept())
    if (std::ranges::find(ids, finding.rule->id) == ids.end()) ids.push_back(finding.rule->id);
  return ids;
}

}  // namespace audit_test
