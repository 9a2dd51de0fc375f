#pragma once

#include "tests/libcanopen/node_fixture.hpp"
#include "tests/libcanopen/sdo_table.hpp"

/// SDO server parameters (CiA 301, 7.5.2.33).
class SdoServers : public NodeTest {
 protected:
  explicit SdoServers(const canopen::Policy& policy = {.extended_identifiers = false})
      : NodeTest{policy, sdo_table()} {
    start();
  }

  void store_ids(std::uint16_t index, std::uint32_t request, std::uint32_t response) {
    store_value(index, 1, request);
    store_value(index, 2, response);
  }

  static constexpr std::uint32_t kInvalidValue = 0x06090030;
  static constexpr std::uint32_t kIncompatible = 0x06040043;
  static constexpr std::uint32_t kDeviceState = 0x08000022;
};
