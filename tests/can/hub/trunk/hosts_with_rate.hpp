#pragma once

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/can/hub/trunk/told_stream.hpp"

namespace told {

/// Three hosts on one bus with a bit rate.
class HostsWithRate : public testing::Test {
 protected:
  static constexpr std::uint32_t kRate = 125'000;
  static constexpr canopen::Duration kBit = 8us;
  using Texts = std::vector<std::string>;

  /// All have joined, and one of them is the arbiter.
  void join_all() {
    for (Host* const host : hosts) host->open();
    pass_time(800ms);
    for (Host* const host : hosts) ASSERT_TRUE(host->trunk.is_up());
  }
  /// Nothing waits any more behind it.
  void turn_all() {
    for (int i = 0; i < 6; ++i)
      for (Host* const host : hosts) host->turn();
  }
  /// Time goes on, as it does for hubs that run; connections that were given up are made anew.
  void pass_time(canopen::Duration time, canopen::Duration step = 20ms) {
    for (const canopen::TimePoint end = server.now + time; server.now < end; turn_all()) {
      server.now += std::min<canopen::Duration>(step, end - server.now);
      for (Host* const host : hosts)
        if (!host->line.is_open) host->open();
    }
  }
  /// The one that is the arbiter, of those that run.
  Host& arbiter() {
    return **std::ranges::find_if(hosts, [](const Host* host) { return host->is_arbiter(); });
  }
  /// One that is not.
  Host& other() {
    return **std::ranges::find_if(hosts, [](const Host* host) { return !host->is_arbiter(); });
  }
  /// @p host stands still from now on.
  void stop(Host& host) { std::erase(hosts, &host); }
  void go_on(Host& host) { hosts.push_back(&host); }

  Server server;
  Host a{server, "a", kRate};
  Host b{server, "b", kRate};
  Host c{server, "c", kRate};
  std::vector<Host*> hosts{&a, &b, &c};
};

}  // namespace told
