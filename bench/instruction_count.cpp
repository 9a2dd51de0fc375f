#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>

#include "bench/operations/operation.hpp"

namespace {

constexpr int kUsage = 2;

int list() {
  for (const bench::OperationRow& row : bench::operations()) {
    std::printf("%s\t%s\n", std::string{row.name}.c_str(), std::string{row.text}.c_str());
  }
  return 0;
}

int run(std::string_view name, std::size_t times) {
  const auto rows = bench::operations();
  const auto row = std::ranges::find(rows, name, &bench::OperationRow::name);
  if (row == rows.end()) {
    std::fprintf(stderr, "instruction_count: no operation %s (--list names them)\n", std::string{name}.c_str());
    return kUsage;
  }
  row->make()->run(times);
  return 0;
}

}  // namespace

/// Does one operation N times and nothing else: the difference of two runs under a counter is the operation.
int main(int count, char** words) {
  if (count == 2 && std::strcmp(words[1], "--list") == 0) return list();
  std::size_t times = 0;
  const bool valid =
      count == 3 && std::from_chars(words[2], words[2] + std::strlen(words[2]), times).ec == std::errc{};
  if (!valid) {
    std::fputs("usage: instruction_count OPERATION N | --list\n", stderr);
    return kUsage;
  }
  try {
    return run(words[1], times);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "instruction_count: %s: %s\n", words[1], error.what());
    return 1;
  }
}
