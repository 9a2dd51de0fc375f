#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/readers/readers.hpp"

namespace {

/// The reader that $FUZZ_READER names.
const fuzz::ReaderRow& chosen() {
  const char* const name = std::getenv("FUZZ_READER");
  const fuzz::ReaderRow* const row = name != nullptr ? fuzz::find_reader(name) : nullptr;
  if (row != nullptr) return *row;
  std::fprintf(stderr, "FUZZ_READER: expected one of");
  for (const fuzz::ReaderRow& each : fuzz::readers()) std::fprintf(stderr, " %s", each.name.data());
  std::fprintf(stderr, "\n");
  std::exit(2);
}

}  // namespace

/// The entry point of libFuzzer: one input for one reader.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ReaderRow& reader = chosen();
  const std::string broken = reader.broken_rule(std::as_bytes(std::span{data, size}));
  if (broken.empty()) return 0;
  std::fprintf(stderr, "broken: %s\n", broken.c_str());
  std::abort();
}
