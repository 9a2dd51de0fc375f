#include <exception>
#include <iostream>

#include <fmt/format.h>
#include <unistd.h>

#include "can/clock/time_share.hpp"
#include "tools/canopen-audit/source/in_order.hpp"
#include "tools/canopen-audit/source/source.hpp"
#include "tools/canopen-check/port_wire.hpp"

namespace audit_tool {
namespace {

constexpr canopen::Duration kBetweenLines = std::chrono::seconds{1};
/// On a bus where frames come as fast as they are read.
constexpr canopen::Duration kLongestDrain = std::chrono::seconds{1};

/// On a terminal: how far it is, in a line that is written over.
class Progress {
 public:
  void show(const audit::Auditor& auditor, canopen::TimePoint now) {
    if (!is_terminal_ || now < next_) return;
    next_ = now + kBetweenLines;
    std::cerr << fmt::format("\r\033[K{} frames, errors {}, warnings {}", auditor.frames(),
                             auditor.findings().count(audit::Severity::Error),
                             auditor.findings().count(audit::Severity::Warning))
              << std::flush;
  }
  ~Progress() {
    if (is_terminal_) std::cerr << "\r\033[K" << std::flush;
  }
  Progress() = default;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

 private:
  bool is_terminal_ = ::isatty(STDERR_FILENO) == 1;
  canopen::TimePoint next_{};
};

/// A bus and what is heard of it.
class Ear {
 public:
  Ear(conformance::PortWire& wire, const Options& options, Hearing& hearing)
      : wire_{wire}, options_{options}, hearing_{hearing}, order_{*hearing.auditor} {}

  void hear() {
    const canopen::TimePoint end = options_.duration ? wire_.now() + *options_.duration : canopen::kNever;
    std::cerr << "listening on " << options_.interface->text << '\n';
    while (!wire_.interrupted() && wire_.now() < end && wire_.up()) {
      if (!hear_until(std::min(end, wire_.now() + kBetweenLines))) order_.flush();
      progress_.show(*hearing_.auditor, wire_.now());
    }
    drain();
    order_.flush();
    hearing_.begin = order_.begin();
    hearing_.end = order_.end();
    if (const std::uint64_t lost = wire_.dropped(); lost > 0)
      hearing_.remarks.push_back(
          fmt::format("{} frames were lost, as they were not read in time: a finding may come of that", lost));
    if (!wire_.up()) hearing_.problem = options_.interface->text + " has gone down";
  }

 private:
  /// False if nothing has come.
  bool hear_until(canopen::TimePoint until) {
    const auto received = wire_.receive(until);
    if (!received) return false;
    order_.add({.frame = received->frame,
                .at = wire_.arrival().value_or(received->time.time_since_epoch()),
                .place = ++frames_});
    return true;
  }

  /// Takes what has come until now and was not read yet.
  void drain() {
    const canopen::TimePoint until = wire_.now() + kLongestDrain;
    while (wire_.up() && wire_.now() < until && hear_until(wire_.now())) {
    }
  }

  conformance::PortWire& wire_;
  const Options& options_;
  Hearing& hearing_;
  InOrder order_;
  Progress progress_{};
  std::uint64_t frames_ = 0;
};

}  // namespace

Hearing hear_bus(const Options& options, audit::Circumstances circumstances) {
  Hearing hearing;
  hearing.auditor = std::make_unique<audit::Auditor>(std::move(circumstances));
  conformance::take_signals();
  try {
    const auto time = bus::TimeShare::join(*options.interface, 0);
    conformance::PortWire wire{*options.interface, time.get(), conformance::SignalEnds::WaitsAtOnce};
    Ear{wire, options, hearing}.hear();
  } catch (const std::exception& error) {
    hearing.problem = error.what();
  }
  hearing.auditor->end();
  if (hearing.problem.empty() && hearing.auditor->frames() == 0)
    hearing.problem = options.interface->text + ": there was no frame";
  return hearing;
}

}  // namespace audit_tool
