/// What a watch makes of messages whose headers the library can, or cannot take apart.
#include "farm/link/watch.hpp"

#include <cstdlib>

#include <gtest/gtest.h>

#include "can/nats/nats_handles.hpp"

namespace farm {
namespace {

/// The first entry of bucket b, and the last one that is there: key k was removed.
nats::Message mark_of_removal() {
  natsMsg* made = nullptr;
  EXPECT_EQ(natsMsg_Create(&made, "$KV.b.k", "$JS.ACK.KV_b.c.1.7.1.1700000000000000000.0", "", 0), NATS_OK);
  EXPECT_EQ(natsMsgHeader_Set(made, "KV-Operation", "DEL"), NATS_OK);
  return nats::Message{made};
}

/// Messages are destroyed by the library, which has to be open.
class WatchedMessages : public testing::Test {
 protected:
  WatchedMessages() { nats_Open(-1); }
  ~WatchedMessages() override { nats_Close(); }
};

TEST_F(WatchedMessages, AreLostWhereItCannotBeSeenWhetherAKeyWasRemoved) {
  std::vector<Entry> told;
  Watch watch{"b", ">", [&told](const Entry& entry) { told.push_back(entry); }, [] {}};
  const nats::Message mark = mark_of_removal();

  for (const char* const unread : {"Status", "KV-Operation"}) {
    SCOPED_TRACE(unread);
    watch.begin();
    ::setenv("UNREAD_HEADER", unread, 1);  // tests/support/unread_header.c
    watch.on_message(mark.get());
    ::unsetenv("UNREAD_HEADER");
    EXPECT_TRUE(told.empty());
    EXPECT_TRUE(watch.is_lost());
  }

  watch.begin();
  watch.on_message(mark.get());
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(told[0].is_deleted);
  EXPECT_FALSE(watch.is_lost());
}

}  // namespace
}  // namespace farm
