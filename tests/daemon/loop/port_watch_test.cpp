#include "daemon/loop/port_watch.hpp"

#include <vector>

#include <gtest/gtest.h>
#include <sys/eventfd.h>

namespace axisd {
namespace {

/// So many ports, polled or tracked by the kernel, and the descriptor beside them.
class PortWatchTest : public testing::TestWithParam<std::size_t> {
 protected:
  PortWatchTest() {
    for (std::size_t i = 0; i < GetParam(); ++i) {
      ports.emplace_back(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
      watch.resize(i + 1);
      watch.set(i, ports[i].get());
    }
  }
  void ring(std::size_t port) { ::eventfd_write(ports[port].get(), 1); }
  void quiet(std::size_t port) {
    eventfd_t value = 0;
    ::eventfd_read(ports[port].get(), &value);
  }
  /// The places that are readable now.
  std::vector<std::size_t> readable() {
    watch.wait(false);
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < count(); ++i)
      if (watch.is_readable(i)) places.push_back(i);
    return places;
  }
  std::size_t count() const { return GetParam() - removed; }
  using Places = std::vector<std::size_t>;

  os::Descriptor others{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)};
  std::vector<os::Descriptor> ports;
  std::size_t removed = 0;
  PortWatch watch{others.get()};
};

TEST_P(PortWatchTest, SaysWhichPortsAreReadable) {
  EXPECT_FALSE(watch.wait(false));
  ring(0);
  ring(GetParam() - 1);

  EXPECT_TRUE(watch.wait(true));
  EXPECT_EQ(readable(), (Places{0, GetParam() - 1}));
  EXPECT_FALSE(watch.others_wait());

  quiet(0);
  EXPECT_EQ(readable(), Places{GetParam() - 1});
}

TEST_P(PortWatchTest, SaysWhatIsBesideThePorts) {
  ::eventfd_write(others.get(), 1);

  EXPECT_TRUE(watch.wait(true));
  EXPECT_TRUE(watch.others_wait());
  EXPECT_EQ(readable(), Places{});
}

TEST_P(PortWatchTest, ForgetsAPortWithoutADescriptor) {
  ring(1);
  watch.set(1, -1);
  EXPECT_EQ(readable(), Places{});

  watch.set(1, ports[1].get());
  EXPECT_EQ(readable(), Places{1});
}

TEST_P(PortWatchTest, KnowsThePlacesBehindOneThatIsRemoved) {
  watch.remove(0);
  removed = 1;
  ring(1);
  ring(GetParam() - 1);

  EXPECT_EQ(readable(), (Places{0, GetParam() - 2}));
}

INSTANTIATE_TEST_SUITE_P(Ports, PortWatchTest, testing::Values(3U, PortWatch::kFew, PortWatch::kFew + 1, 20U));

}  // namespace
}  // namespace axisd
