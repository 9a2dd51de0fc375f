#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <thread>

#include "bench/bus/slave_client.hpp"
#include "bench/number.hpp"

namespace {

using bench::SlaveClient;
using bench::Target;
using Clock = std::chrono::steady_clock;
using Times = std::vector<std::uint64_t>;  // ns

constexpr int kUsage = 2;
constexpr unsigned long kWarmUp = 200;
constexpr unsigned long kSyncPause = 300;  // µs between SYNCs

void print(const char* test, const char* what, std::uint64_t value) {
  std::printf("%s_%s %llu\n", test, what, static_cast<unsigned long long>(value));
}

void print_times(const char* test, Times& times) {
  constexpr std::size_t kHundred = 100;
  std::sort(times.begin(), times.end());
  print(test, "p50", times[times.size() / 2]);
  print(test, "p99", times[times.size() * (kHundred - 1) / kHundred]);
}

/// CPU time of the slave since the construction.
class CpuTime {
 public:
  explicit CpuTime(const Target& target) : process_{target.process}, start_{read()} {}
  /// Prints it for each of @p times.
  void print_each(const char* test, std::uint64_t times) const {
    if (process_ != 0 && times != 0) print(test, "cpu", (read() - start_) / times);
  }

 private:
  std::uint64_t read() const { return process_ != 0 ? bench::cpu_time(process_) : 0; }
  unsigned long process_;
  std::uint64_t start_;
};

/// The time of each of @p count steps, with a pause of @p pause_us in front of it.
template <class Step>
Times measure(unsigned long count, unsigned long pause_us, const Step& step) {
  Times times(count);
  for (std::uint64_t& time : times) {
    if (pause_us != 0) std::this_thread::sleep_for(std::chrono::microseconds{pause_us});
    const Clock::time_point before = Clock::now();
    step();
    time = static_cast<std::uint64_t>((Clock::now() - before).count());
  }
  return times;
}

/// Prints the times and the CPU time of @p count steps.
template <class Step>
void report(const char* test, const Target& target, unsigned long count, const Step& step) {
  measure(kWarmUp, 0, step);
  const CpuTime cpu{target};
  Times times = measure(count, target.pause_us, step);
  cpu.print_each(test, count);
  print_times(test, times);
}

void upload(SlaveClient& client, const Target& target, unsigned long count) {
  const can_frame first = client.upload({0x1000, 0});
  report("upload", target, count, [&] {
    if (std::memcmp(client.upload({0x1000, 0}).data, first.data, sizeof first.data) != 0)
      throw std::runtime_error{"an answer differs from the first one"};
  });
}

void download(SlaveClient& client, const Target& target, unsigned long count) {
  std::uint32_t value = 0;
  constexpr unsigned kSize = 4;
  report("download", target, count, [&] { client.download(target.written, ++value, kSize); });
}

/// With a pause at least as long as the slave needs to sleep again.
void sync(SlaveClient& client, const Target& target, unsigned long count) {
  Target patient = target;
  patient.pause_us = std::max(target.pause_us, kSyncPause);
  report("sync", patient, count, [&] { client.sync(); });
}

void start(SlaveClient& client, const Target&, unsigned long) {
  client.start_node();
}

/// Every TPDO on every SYNC. The further axes of a new unit have no identifiers for theirs.
void synchronous(SlaveClient& client, const Target& target, unsigned long) {
  constexpr unsigned kFirst = 0x1800, kAxisStride = 0x40, kOfAnAxis = 4;
  constexpr std::uint32_t kFirstCobId = 0x40000180, kFunctionStride = 0x100;
  for (unsigned i = 0; i < target.pdos; ++i) {
    const unsigned axis = target.axes > 1 ? i / kOfAnAxis : 0;
    const unsigned place = i - axis * kOfAnAxis;
    const auto index = static_cast<std::uint16_t>(kFirst + axis * kAxisStride + place);
    client.download({index, 2}, 1, 1);
    if (axis > 0) client.download({index, 1}, kFirstCobId + place * kFunctionStride + target.node + axis, 4);
  }
}

void heartbeat(SlaveClient& client, const Target&, unsigned long milliseconds) {
  client.download({0x1017, 0}, static_cast<std::uint32_t>(milliseconds), 2);
}

void idle(SlaveClient& client, const Target& target, unsigned long seconds) {
  const CpuTime cpu{target};
  Times times = client.heartbeats(std::chrono::seconds{seconds});
  cpu.print_each("idle", seconds);
  print("heartbeat", "count", times.size());
  print_times("heartbeat", times);
}

/// Back to back; done when the slave answers again.
void flood(SlaveClient& client, const Target& target, unsigned long count) {
  const CpuTime cpu{target};
  for (unsigned long i = 1; i <= count; ++i) client.send_rpdo(static_cast<std::uint32_t>(i));
  client.upload({0x1000, 0});
  cpu.print_each("flood", count);
}

struct Test {
  std::string_view name;
  void (*run)(SlaveClient&, const Target&, unsigned long count);
};
constexpr std::array kTests{
    Test{"download", download}, Test{"flood", flood}, Test{"heartbeat", heartbeat},     Test{"idle", idle},
    Test{"start", start},       Test{"sync", sync},   Test{"synchronous", synchronous}, Test{"upload", upload},
};

template <class Number>
bool parse(std::string_view word, Number& number, int base = 10) {
  return bench::parse(word, Number{1}, std::numeric_limits<Number>::max(), number, base);
}

/// Takes one option and its value; false if it is none.
bool take_option(Target& target, std::string_view name, std::string_view value) {
  constexpr int kHexadecimal = 16;
  if (name == "--pdos") return parse(value, target.pdos);
  if (name == "--axes") return parse(value, target.axes);
  if (name == "--process") return parse(value, target.process);
  if (name == "--pause") return parse(value, target.pause_us);
  if (name == "--controlword") return parse(value, target.controlword, kHexadecimal);
  return name == "--object" && parse(value, target.written.index, kHexadecimal);
}

/// A test and how much of it.
struct Order {
  void (*run)(SlaveClient&, const Target&, unsigned long count);
  unsigned long count;
};

/// The order TEST[:COUNT]; nothing if there is no such test.
std::optional<Order> order_of(std::string_view word) {
  const std::size_t colon = std::min(word.find(':'), word.size());
  const auto* const test = std::find_if(kTests.begin(), kTests.end(),
                                        [&](const Test& row) { return row.name == word.substr(0, colon); });
  unsigned long count = 1;
  if (test == kTests.end() || (colon < word.size() && !parse(word.substr(colon + 1), count))) return std::nullopt;
  return Order{test->run, count};
}

/// Nothing if a word is no test, or if there is none.
std::optional<std::vector<Order>> orders_of(std::span<char*> words) {
  std::vector<Order> orders;
  for (const char* const word : words) {
    const std::optional<Order> order = order_of(word);
    if (!order) return std::nullopt;
    orders.push_back(*order);
  }
  return orders.empty() ? std::nullopt : std::optional{std::move(orders)};
}

int usage() {
  std::fputs(
      "usage: bus_client INTERFACE NODE [--pdos N] [--axes N] [--process PID] [--object INDEX] [--pause US] "
      "[--controlword WORD] TEST[:COUNT]...\n"
      "tests: upload download sync flood (COUNT of them), idle (seconds), start, synchronous, heartbeat (ms)\n",
      stderr);
  return kUsage;
}

}  // namespace

/// Asks a slave what a master would, checks every answer, and prints lines "TEST_WHAT NUMBER": p50 and p99 of the
/// round trips, cpu of the slave for each of them (idle: a second), all in ns.
int main(int count, char** words) {
  constexpr unsigned kHighestNode = 127;
  Target target;
  if (count < 4 || !bench::parse(words[2], 1U, kHighestNode, target.node)) return usage();
  target.interface = words[1];
  int next = 3;
  for (; next + 1 < count && words[next][0] == '-'; next += 2)
    if (!take_option(target, words[next], words[next + 1])) return usage();
  const auto orders = orders_of({words + next, words + count});
  if (!orders) return usage();
  try {
    SlaveClient client{target};
    for (const Order& order : *orders) order.run(client, target, order.count);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bus_client: %s\n", error.what());
    return 1;
  }
}
