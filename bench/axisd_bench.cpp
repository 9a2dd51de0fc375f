#include <string>

#include <benchmark/benchmark.h>

#include "bench/operations/operation.hpp"

namespace {

// Many operations between two looks at the clock's state: the loop of the library would weigh as much as they do.
constexpr std::int64_t kBatch = 256;

void measure(benchmark::State& state, const bench::OperationRow& row) {
  const auto operation = row.make();
  while (state.KeepRunningBatch(kBatch)) operation->run(kBatch);
}

}  // namespace

int main(int count, char** words) {
  const auto rows = bench::operations();
  for (const bench::OperationRow& row : rows) {
    benchmark::RegisterBenchmark(std::string{row.name}.c_str(),
                                 [&row](benchmark::State& state) { measure(state, row); });
  }
  benchmark::Initialize(&count, words);
  if (benchmark::ReportUnrecognizedArguments(count, words)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
