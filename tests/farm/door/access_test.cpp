#include "farm/door/service/access.hpp"

#include <gtest/gtest.h>

#include "farm/door/service/outlets.hpp"

namespace farm {
namespace {

TEST(AccessTest, ReadingIsWhatChangesNothing) {
  for (const char* const method :
       {"status", "parameter.read", "signal.list", "samples.subscribe", "frames.unsubscribe"})
    EXPECT_TRUE(is_read(method, nlohmann::json::object())) << method;
  for (const char* const method : {"parameter.write", "fault.inject", "power.off", "fly"})
    EXPECT_FALSE(is_read(method, nlohmann::json::object())) << method;
}

TEST(AccessTest, NothingIsToldToSubjectsOfTheServerOrOfTheFarm) {
  for (const char* const subject : {"_INBOX.x.1", "mine", "mine.5-a"})
    EXPECT_TRUE(Outlets::is_subject(subject)) << subject;
  for (const char* const subject : {"", ".", "a.", ".a", "a..b", "a b", "a.*", ">", "a\r\n", "$SYS.x",
                                    "axisd.lab.line1.5.rpc", "axisd_host.lab.a.door"})
    EXPECT_FALSE(Outlets::is_subject(subject)) << subject;
  EXPECT_FALSE(Outlets::is_subject(std::string(300, 'x')));
}

}  // namespace
}  // namespace farm
