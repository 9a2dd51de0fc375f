#pragma once

#include <utility>

#include "tests/libcanopen/node_fixture.hpp"
#include "tests/libcanopen/service_table.hpp"

/// Node 5 over the table of error control, EMCY, TIME and storage.
class ServiceTest : public NodeTest {
 protected:
  explicit ServiceTest(const canopen::Policy& policy = {.extended_identifiers = false})
      : NodeTest{policy, service_table()} {}

  /// What the application was told since the last of these calls, errors apart.
  Lines told() { return std::exchange(application.told, {}); }
  /// Which errors of the communication came and went since the last of these calls.
  Lines errors() { return std::exchange(application.errors, {}); }
  /// Takes the node to @p state; what it says and tells meanwhile is forgotten.
  void take_to(canopen::NmtState state) {
    const bool stops = state == canopen::NmtState::Stopped;
    says(stops ? "000#0205" : state == canopen::NmtState::Operational ? "000#0105" : "000#8005");
    ASSERT_EQ(node->state(), state);
    application.told.clear();
  }
};
