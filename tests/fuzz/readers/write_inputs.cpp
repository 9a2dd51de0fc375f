// write_inputs READER FOLDER: what a reader begins with as files, for the fuzzer.
#include <cstdio>
#include <fstream>
#include <string>

#include "tests/fuzz/readers/readers.hpp"

int main(int argc, char** argv) {
  const fuzz::ReaderRow* const reader = argc == 3 ? fuzz::find_reader(argv[1]) : nullptr;
  if (reader == nullptr) {
    std::fprintf(stderr, "usage: write_inputs READER FOLDER; READER is one of\n");
    for (const fuzz::ReaderRow& each : fuzz::readers())
      std::fprintf(stderr, "  %-14s %s\n", each.name.data(), each.summary.data());
    return 2;
  }
  int number = 0;
  for (const std::string& input : fuzz::inputs_of(*reader))
    std::ofstream{std::string{argv[2]} + "/made-" + std::to_string(++number), std::ios::binary} << input;
  return 0;
}
