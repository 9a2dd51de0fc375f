#pragma once

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/can/hub/trunk/told_stream.hpp"

namespace told {

using namespace std::chrono_literals;

/// Two hosts on one bus.
class SeveralHosts : public testing::Test {
 protected:
  /// Both have joined and know each other.
  void join_all() {
    for (Host* const host : hosts) host->open();
    pass_time(150ms);
  }
  /// Nothing waits any more behind it.
  void turn_all() {
    for (int i = 0; i < 4; ++i)
      for (Host* const host : hosts) host->turn();
  }
  /// Time goes on, as it does for hubs that run.
  void pass_time(canopen::Duration time) {
    for (const canopen::TimePoint end = server.now + time; server.now < end; turn_all())
      server.now += std::min<canopen::Duration>(50ms, end - server.now);
  }

  Server server;
  Host a{server, "a"};
  Host b{server, "b"};
  std::vector<Host*> hosts{&a, &b};
};

}  // namespace told
