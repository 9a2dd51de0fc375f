#pragma once

#include <string>
#include <vector>

namespace e2e {

/// The CAN interface of all tests.
inline constexpr const char* kTestInterface = "vcan0";

/// What axisd serves to meet the tests' sockets on kTestInterface: that name, or under `with-can` its bus
/// (unix:PATH).
std::string served_interface();

/// What other programs need in their environment (NAME=VALUE) to meet them: nothing, or what `with-can` has set.
std::vector<std::string> bus_environment();

}  // namespace e2e
