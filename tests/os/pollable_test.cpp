#include "os/pollable.hpp"

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>

namespace os {
namespace {

bool is_ready(const Pollable& pollable) {
  pollfd wanted{pollable.descriptor(), POLLIN, 0};
  return ::poll(&wanted, 1, 0) == 1;
}

TEST(Pollable, IsReadyWhileOneOfItsDescriptorsIs) {
  const Descriptor event{::eventfd(0, EFD_NONBLOCK)};
  const Descriptor other{::eventfd(0, EFD_NONBLOCK)};
  Pollable pollable;
  ASSERT_TRUE(pollable.add(event.get(), EPOLLIN));
  ASSERT_TRUE(pollable.add(other.get(), EPOLLIN));
  EXPECT_FALSE(is_ready(pollable));

  ::eventfd_write(other.get(), 1);
  EXPECT_TRUE(is_ready(pollable));
  eventfd_t value = 0;
  ::eventfd_read(other.get(), &value);
  EXPECT_FALSE(is_ready(pollable));
}

TEST(Pollable, ForgetsWhatIsRemovedOrClosed) {
  const Descriptor removed{::eventfd(1, EFD_NONBLOCK)};
  Descriptor closed{::eventfd(1, EFD_NONBLOCK)};
  Pollable pollable;
  ASSERT_TRUE(pollable.add(removed.get(), EPOLLIN));
  ASSERT_TRUE(pollable.add(closed.get(), EPOLLIN));

  pollable.remove(removed.get());
  EXPECT_TRUE(is_ready(pollable));
  closed = Descriptor{};
  EXPECT_FALSE(is_ready(pollable));
}

TEST(Pollable, SaysThatADescriptorCannotBeWatched) {
  Pollable pollable;
  EXPECT_FALSE(pollable.add(-1, EPOLLIN));
}

}  // namespace
}  // namespace os
