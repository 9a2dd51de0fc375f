#include "service/service_events.hpp"

#include <csignal>

#include <gtest/gtest.h>

#include "tests/daemon/server/control_client.hpp"

namespace axisd {
namespace {

TEST(ServiceEvents, LeavesAnIgnoredHangUpAlone) {
  const auto before = std::signal(SIGHUP, SIG_IGN);  // as nohup does
  int stops = 0;
  {
    ServiceEvents events{[&] { ++stops; }};
    ::raise(SIGHUP);
    settle(events);
  }
  std::signal(SIGHUP, before);
  EXPECT_EQ(stops, 0);
}

TEST(ServiceEvents, CallsForTheEndOnAHangUp) {
  int stops = 0;
  ServiceEvents events{[&] { ++stops; }};

  ::raise(SIGHUP);
  settle(events);

  EXPECT_EQ(stops, 1);
}

TEST(ServiceEvents, CallsForTheEndOnSigtermAndSigint) {
  int stops = 0;
  ServiceEvents events{[&] { ++stops; }};

  ::raise(SIGTERM);
  settle(events);
  EXPECT_EQ(stops, 1);
  ::raise(SIGINT);
  settle(events);
  EXPECT_EQ(stops, 2);
}

}  // namespace
}  // namespace axisd
