#include "tests/e2e/test_bus.hpp"

#include <cstdlib>

namespace e2e {

std::string served_interface() {
  const char* const bus = std::getenv("CAN_BUS");
  return bus != nullptr ? std::string{"unix:"} + bus : kTestInterface;
}

std::vector<std::string> bus_environment() {
  std::vector<std::string> entries;
  for (const char* const name : {"CAN_BUS", "CAN_TIME", "LD_PRELOAD"}) {
    if (const char* const value = std::getenv(name)) entries.push_back(std::string{name} + '=' + value);
  }
  return entries;
}

}  // namespace e2e
