// What whole cycles of a unit take: cycle_speed [SLICES]. Its axes are advanced each by itself and side by side in
// the lanes of every kind of processor that this one is, slice by slice in turns, so that what else the machine
// does counts for all.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "bench/median.hpp"
#include "bench/number.hpp"
#include "bench/operations/operation.hpp"
#include "motor/lockstep/lockstep.hpp"

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kTimes = 500;  // of a slice

/// In groups of one, an axis is left to itself.
constexpr motor::LaneVariant kEachByItself{
    .name = "(each by itself)", .lanes = 1, .size = 0, .is_supported = nullptr, .form = nullptr};

/// One way to do an operation.
struct Way {
  const motor::LaneVariant* variant;
  std::vector<double> slices;  ///< ns each time
};

void run_slice(bench::Operation& operation, Way& way) {
  motor::use(*way.variant);
  const auto start = Clock::now();
  operation.run(kTimes);
  const double elapsed = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  way.slices.push_back(elapsed / kTimes);
}

/// Rows of the operation called @p name, in every way: the same unit in all, for its place in memory counts too.
void measure(std::string_view name, int slices) {
  const auto all = bench::operations();
  const auto row = std::ranges::find(all, name, &bench::OperationRow::name);
  const std::unique_ptr<bench::Operation> operation = row->make();
  std::vector<Way> ways;
  ways.push_back({&kEachByItself, {}});
  for (const motor::LaneVariant* const variant : motor::lane_variants())
    if (variant->is_supported()) ways.push_back({variant, {}});
  for (int i = 0; i < slices; ++i)
    for (Way& way : ways) run_slice(*operation, way);
  for (const Way& way : ways) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < way.slices.size(); ++i) ratios.push_back(way.slices[i] / ways[0].slices[i]);
    std::printf("| %.*s | %s | %.2f | %.2f |\n", static_cast<int>(row->text.size()), row->text.data(),
                way.variant->name, bench::median(way.slices) / 1e3, bench::median(ratios));
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const std::span words{argv, static_cast<std::size_t>(argc)};
  int slices = 41;
  if (argc > 2 || (argc > 1 && !bench::parse(words[1], 1, 10000, slices))) {
    std::fputs("usage: cycle_speed [SLICES (1..10000)]\n", stderr);
    return 2;
  }
  std::puts("| cycle | lanes of | us | of each by itself |");
  std::puts("|---|---|---:|---:|");
  for (const std::string_view name :
       {"device/cycle_4ms", "device/cycle_1ms", "device/cycle_quiet", "axis/turning"})
    measure(name, slices);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "cycle_speed: %s\n", error.what());
  return 1;
}
