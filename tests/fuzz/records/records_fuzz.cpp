#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/profidrive/fuzzed_unit.hpp"

/// The entry point of libFuzzer: one input, played to a unit.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static profidrive::FuzzedUnit unit;
  const std::string broken = unit.play({data, size});
  if (broken.empty()) return 0;
  std::fprintf(stderr, "broken: %s\n", broken.c_str());
  std::abort();
}
