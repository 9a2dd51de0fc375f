#pragma once

#include <chrono>
#include <functional>

#include <gtest/gtest.h>
#include <poll.h>

#include "service/service_events.hpp"

namespace farm::agent {

/// A loop of events for tests with programs.
class ProcessFixture : public testing::Test {
 protected:
  /// Handles events until @p is_done, for 20 s at most; whether it is.
  bool wait_for(const std::function<bool()>& is_done) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{20};
    while (!is_done() && std::chrono::steady_clock::now() < end) {
      pollfd events_come{events.descriptor(), POLLIN, 0};
      ::poll(&events_come, 1, 100);
      while (events.dispatch()) continue;
    }
    return is_done();
  }

  axisd::ServiceEvents events;
};

}  // namespace farm::agent
