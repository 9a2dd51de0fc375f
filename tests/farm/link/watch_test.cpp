/// What a watch makes of messages whose headers the library can, or cannot take apart.
#include "farm/link/watch.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "can/nats/nats_handles.hpp"

static bool has_memory = true;

/// In front of the one of the library.
extern "C" natsStatus natsMsgHeader_Get(natsMsg* message, const char* key, const char** value) {
  using Function = natsStatus (*)(natsMsg*, const char*, const char**);
  static const auto real = reinterpret_cast<Function>(::dlsym(RTLD_NEXT, "natsMsgHeader_Get"));
  return has_memory ? real(message, key, value) : NATS_NO_MEMORY;
}

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

  watch.begin();
  has_memory = false;
  watch.on_message(mark.get());
  has_memory = true;
  EXPECT_TRUE(told.empty());
  EXPECT_TRUE(watch.is_lost());

  watch.begin();
  watch.on_message(mark.get());
  ASSERT_EQ(told.size(), 1U);
  EXPECT_TRUE(told[0].is_deleted);
  EXPECT_FALSE(watch.is_lost());
}

}  // namespace
}  // namespace farm
