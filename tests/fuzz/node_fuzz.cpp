#include "tests/fuzz/worlds.hpp"

/// The entry point of libFuzzer: one input, played from the state after a reset.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static fuzz::Worlds worlds;
  worlds.play({data, size});
  return 0;
}
