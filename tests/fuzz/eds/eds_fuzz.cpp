#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/eds/reader_properties.hpp"

/// The entry point of libFuzzer: one input, read as an EDS.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text{data, data + size};
  const std::string broken = eds::broken_property(text);
  if (broken.empty()) return 0;
  std::fprintf(stderr, "broken: %s\n", broken.c_str());
  std::abort();
}
