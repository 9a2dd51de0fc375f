#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "bench/bus/fan_out.hpp"
#include "bench/median.hpp"
#include "bench/number.hpp"

/// What the hub of a user-space bus costs beside a program that reads a message from one socket and writes it to
/// all others.
namespace {

using bench::FanOut;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kDeliveries = 2000;  // of one slice, about
constexpr std::size_t kBurst = userbus::kMostFrames;
constexpr std::size_t kMany = 127;

/// Of a frame, in ns: processor time of who hands it on, and the time until the last one has it.
struct Cost {
  double processor = 0;
  double elapsed = 0;
};

/// How frames are sent.
struct Traffic {
  std::size_t frames = 1;  ///< back to back, before everybody is waited for
  bool in_one = false;     ///< in one message
};

Cost measure(const FanOut& fan_out, const Traffic& traffic, std::size_t times) {
  const std::int64_t processor = fan_out.processor_time();
  const Clock::time_point before = Clock::now();
  for (std::size_t i = 0; i < times; ++i) fan_out.pass(traffic.frames, traffic.in_one);
  const double elapsed = std::chrono::duration<double, std::nano>(Clock::now() - before).count();
  const double frames = static_cast<double>(times * traffic.frames);
  return {static_cast<double>(fan_out.processor_time() - processor) / frames, elapsed / frames};
}

/// Two that are measured in turns, slice by slice: medians of both, and of the ratios of slices.
struct Comparison {
  Cost one;
  Cost other;
  Cost ratio;
};

double median_of(const std::vector<Cost>& costs, double Cost::*part) {
  std::vector<double> values;
  for (const Cost& cost : costs) values.push_back(cost.*part);
  return bench::median(std::move(values));
}

Cost medians(const std::vector<Cost>& costs) {
  return {median_of(costs, &Cost::processor), median_of(costs, &Cost::elapsed)};
}

Comparison compare(const FanOut& one, const FanOut& other, const Traffic& traffic, std::size_t times,
                   unsigned slices) {
  std::vector<Cost> of_one, of_other, ratios;
  measure(one, traffic, times / 4 + 1);
  measure(other, traffic, times / 4 + 1);
  for (unsigned i = 0; i < slices; ++i) {
    const Cost a = measure(one, traffic, times);
    const Cost b = measure(other, traffic, times);
    of_one.push_back(a);
    of_other.push_back(b);
    ratios.push_back({a.processor / b.processor, a.elapsed / b.elapsed});
  }
  return {medians(of_one), medians(of_other), medians(ratios)};
}

void print(const std::string& name, const Comparison& comparison) {
  constexpr double kMicrosecond = 1000;
  std::printf("| %s | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |\n", name.c_str(),
              comparison.one.processor / kMicrosecond, comparison.other.processor / kMicrosecond,
              comparison.ratio.processor, comparison.one.elapsed / kMicrosecond,
              comparison.other.elapsed / kMicrosecond, comparison.ratio.elapsed);
  std::fflush(stdout);
}

/// How often a slice has messages with @p deliveries: as often as takes a few milliseconds.
std::size_t times_of(std::size_t deliveries) {
  constexpr std::size_t kAtLeast = 10;  // a message costs something, whoever hears it
  return std::max<std::size_t>(1, kDeliveries / std::max(kAtLeast, deliveries));
}

class Rows {
 public:
  Rows(const bench::Hub& hub, unsigned slices) : hub_{hub}, slices_{slices} {}

  /// A frame that all of @p members hear, sent when the last one has the one before.
  void one_at_a_time(std::size_t members) const {
    const FanOut hub = hub_of({.members = members});
    const std::string text = std::to_string(members) + " members, all hear a frame";
    row(text, hub, FanOut::plain(members, true), {}, members);
    row(text + "; floor without poll", hub, FanOut::plain(members, false), {}, members);
  }
  /// Frames without a pause, to members that take one in a message, and many.
  void back_to_back(std::size_t members) const {
    const FanOut plain = FanOut::plain(members, false);
    const std::string text = std::to_string(members) + " members, 32 frames back to back";
    const Traffic apart{.frames = kBurst, .in_one = false};
    row(text + ", one in a message", hub_of({.members = members}), plain, apart, kBurst * members);
    row(text + ", several in a message to members", hub_of({.members = members, .most_frames = kBurst}), plain,
        apart, kBurst * members);
  }
  void in_one_message(std::size_t members) const {
    row(std::to_string(members) + " members, 32 frames in one message",
        hub_of({.members = members, .most_frames = kBurst}), FanOut::plain(members, true),
        {.frames = kBurst, .in_one = true}, members);
  }
  /// The other one is a hub likewise.
  void that_one_hears(std::size_t members) const {
    row("a frame that one hears: of " + std::to_string(members) + " members, and of 2",
        hub_of({.members = members, .one_hears = true}), hub_of({.members = 2, .one_hears = true}), {}, 2);
  }

 private:
  [[nodiscard]] FanOut hub_of(const bench::Wishes& wishes) const {
    return FanOut::of_hub(hub_.path(), hub_.process(), wishes);
  }
  void row(const std::string& text, const FanOut& one, const FanOut& other, const Traffic& traffic,
           std::size_t deliveries) const {
    print(text, compare(one, other, traffic, times_of(deliveries), slices_));
  }

  const bench::Hub& hub_;
  unsigned slices_;
};

}  // namespace

int main(int count, char** words) {
  constexpr int kUsage = 2;
  unsigned slices = 0;
  if (count != 3 || !bench::parse(words[2], 1U, 10'000U, slices)) {
    std::fputs("usage: hub_cost CANHUB SLICES\n", stderr);
    return kUsage;
  }
  try {
    const bench::Hub hub{words[1]};
    std::puts("| | CPU (us) | CPU of the other | ratio | to the last (us) | of the other | ratio |");
    std::puts("|---|---:|---:|---:|---:|---:|---:|");
    const Rows rows{hub, slices};
    for (const std::size_t members : {2UL, 8UL, 32UL, kMany}) rows.one_at_a_time(members);
    for (const std::size_t members : {2UL, 8UL, 32UL, kMany}) rows.back_to_back(members);
    rows.in_one_message(kMany);
    rows.that_one_hears(kMany);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "hub_cost: %s\n", error.what());
    return 1;
  }
  return 0;
}
