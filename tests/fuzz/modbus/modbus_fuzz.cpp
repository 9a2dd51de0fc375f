#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/modbus/stream_properties.hpp"

/// The entry point of libFuzzer: one input, the life of a connection of Modbus TCP.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string broken = modbus::broken_rule({data, size});
  if (broken.empty()) return 0;
  std::fprintf(stderr, "broken: %s\n", broken.c_str());
  std::abort();
}
