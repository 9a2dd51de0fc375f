#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include "bench/bus/raw_socket.hpp"
#include "bench/number.hpp"
#include "bench/trunk/tally.hpp"
#include "can/hub/trunk/latency.hpp"
#include "os/clock.hpp"

/// A member of a bus that sends numbered frames and keeps account of what it hears of all members, its own frames
/// included.
namespace {

using canopen::Duration;
using canopen::TimePoint;

struct Options {
  std::string interface;
  unsigned members = 1;
  unsigned number = 0;      ///< of this one
  std::uint32_t count = 0;  ///< frames of each
  unsigned rate = 0;        ///< frames a second of all members; 0: as fast as all keep pace
};

TimePoint now() noexcept {
  return TimePoint{os::monotonic_time()};
}

class Member {
 public:
  explicit Member(const Options& options)
      : options_{options},
        socket_{options.interface, {&bench::kEverything, 1}},
        tally_{options.members, options.count},
        sent_at_(options.count) {
    socket_.hear_own();
  }

  /// Until the frames of all were heard, or nothing comes any more.
  void run() {
    begin_ = heard_at_ = now();
    while (!tally_.is_complete()) {
      send_due();
      if (!receive_some() && !wait()) break;
    }
  }
  [[nodiscard]] std::string report() const {
    constexpr double kHalf = 0.5;
    constexpr double kNearlyAll = 0.99;
    return fmt::format(R"({{"tally": {}, "echo_ns": {{"median": {}, "p99": {}}}}})", tally_.report(),
                       echo_.quantile(kHalf).count(), echo_.quantile(kNearlyAll).count());
  }

 private:
  /// When frame @p number is to be sent; members take turns.
  [[nodiscard]] TimePoint due(std::uint32_t number) const noexcept {
    constexpr std::int64_t kSecond = 1'000'000'000;
    const std::int64_t turn = std::int64_t{number} * options_.members + options_.number;
    return begin_ + Duration{turn * kSecond / options_.rate};
  }

  /// Without a rate nobody is more than a window ahead of the slowest, so that what waits for a member always has
  /// room in its hub.
  [[nodiscard]] bool may_send() const noexcept {
    constexpr std::uint32_t kWindow = 256;
    if (sent_ == options_.count) return false;
    return options_.rate == 0 ? sent_ < tally_.least() + kWindow : due(sent_) <= now();
  }

  void send_due() {
    for (; may_send(); ++sent_) {
      sent_at_[sent_] = now();
      if (!socket_.send_now(bench::numbered(options_.number, sent_))) return;
    }
  }

  bool receive_some() {
    constexpr int kMost = 64;
    can_frame frame{};
    int count = 0;
    for (; count < kMost && socket_.receive_now(frame); ++count) take(frame);
    return count > 0;
  }

  void take(const can_frame& frame) {
    heard_at_ = now();
    if (bench::sender_of(frame) == options_.number) echo_.add(heard_at_ - sent_at_[bench::number_of(frame)]);
    tally_.add(frame, heard_at_);
  }

  /// False if nothing comes any more.
  [[nodiscard]] bool wait() const noexcept {
    constexpr Duration kPatience = std::chrono::seconds{5};
    constexpr std::int64_t kSecond = 1'000'000'000;
    const TimePoint end = heard_at_ + kPatience;
    const bool is_paced = options_.rate != 0 && sent_ < options_.count;
    const Duration left = std::max((is_paced ? due(sent_) : end) - now(), Duration{0});
    const timespec time{.tv_sec = left.count() / kSecond, .tv_nsec = left.count() % kSecond};
    pollfd descriptor{socket_.descriptor(), POLLIN, 0};
    return ::ppoll(&descriptor, 1, &time, nullptr) > 0 || now() < end;
  }

  Options options_;
  bench::RawSocket socket_;
  bench::Tally tally_;
  std::vector<TimePoint> sent_at_;
  hub::trunk::Latency echo_;
  TimePoint begin_{};
  TimePoint heard_at_{};
  std::uint32_t sent_ = 0;
};

void wait_for_line() {
  while (true) {
    const int letter = std::getchar();
    if (letter == '\n' || letter == EOF) return;
  }
}

bool read(int count, char** words, Options& options) {
  constexpr int kWords = 6;
  constexpr unsigned kMostMembers = 256;
  constexpr std::uint32_t kMostFrames = 1'000'000'000;
  constexpr unsigned kHighestRate = 1'000'000;
  if (count != kWords) return false;
  options.interface = words[1];
  return bench::parse(words[2], 1U, kMostMembers, options.members) &&
         bench::parse(words[3], 0U, options.members - 1, options.number) &&
         bench::parse(words[4], std::uint32_t{1}, kMostFrames, options.count) &&
         bench::parse(words[5], 0U, kHighestRate, options.rate);
}

}  // namespace

int main(int count, char** words) {
  constexpr int kUsage = 2;
  Options options;
  if (!read(count, words, options)) {
    std::fputs("usage: trunk_member INTERFACE MEMBERS NUMBER COUNT RATE\n", stderr);
    return kUsage;
  }
  try {
    Member member{options};
    std::puts("ready");
    std::fflush(stdout);
    wait_for_line();
    member.run();
    std::puts(member.report().c_str());
    std::fflush(stdout);
    wait_for_line();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "trunk_member: %s\n", error.what());
    return 1;
  }
}
