#include <algorithm>

#include <fmt/format.h>

#include "tools/canopen-check/core/run/runner.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

// What a check may leave behind: a node that has gone, or that refuses Operational from then on.
namespace conformance {
namespace {

/// Requests for 1000h:00 until a node counts as absent behind a check.
constexpr int kAttempts = 2;
/// Frames that a finding about its absence keeps.
constexpr std::size_t kMostFrames = 60;

/// "writing 1016h:01", for a request that names an entry.
std::string what_is_asked(const canopen::Frame& request) {
  constexpr std::uint8_t kSpecifier = 0xE0, kDownload = 0x20, kBlockDownload = 0xC0;
  const auto specifier = static_cast<std::uint8_t>(request.data[0] & kSpecifier);
  const auto [index, sub_index] = multiplexor_of(request);
  return fmt::format("{} {}", specifier == kDownload || specifier == kBlockDownload ? "writing" : "reading",
                     to_text(Subject{index, sub_index}));
}

}  // namespace

bool Runner::answers(int attempts) {
  for (int attempt = 0; attempt < attempts && !session_.ended(); ++attempt) {
    sdo_.ask_again();
    const SdoAnswer answer = sdo_.upload(object::kDeviceType, 0);
    if (answer.done() || answer.aborted()) return true;
  }
  return false;
}

std::string Runner::consequence(const Check& check, RunReport& report) {
  if (!session_.bus_is_up()) return fmt::format("the bus is down since {}", check.id);
  if (session_.interrupted()) return "interrupted";
  if (!gone_) return {};
  if (!revive()) return fmt::format("the node is gone since {}", check.id);
  gone_ = false;
  report.notes.push_back(fmt::format("the node was gone after {}; a reset brought it back", check.id));
  return {};
}

void Runner::ask_for_operational() {
  Context context{session_, sdo_, *eds_, *settings_, manners_};
  session_.command(canopen::NmtCommand::EnterPreOperational);
  manners_.refuses_operational = refusal_of_operational(context);
  session_.clean_up(true);
  session_.command(canopen::NmtCommand::EnterPreOperational);
  (void)context.undo().restore();
  session_.clean_up(false);
}

void Runner::judge_operational(const Check& check, CheckResult& result) {
  const bool doubtful =
      result.outcome == Outcome::Failed || (result.outcome == Outcome::Passed && !manners_.operational_asked);
  if (!doubtful || !was_operational_ || session_.ended()) return;
  ask_for_operational();
  const std::string refusal = manners_.refuses_operational;
  if (refusal.empty()) return;
  if (settings_->allow_reset) {
    Context context{session_, sdo_, *eds_, *settings_, manners_};
    if (context.restart(canopen::NmtCommand::ResetNode)) ask_for_operational();
  }
  result = {.check = &check};
  if (manners_.refuses_operational.empty()) {
    perform(check, result);
    result.notes.push_back(refusal + "; it was reset, and the check run again");
  } else {
    result.outcome = Outcome::Skipped;
    result.reason = refusal;
  }
}

void Runner::judge_presence(CheckResult& result) {
  const bool doubtful = result.outcome == Outcome::Failed || sdo_.unanswered();
  if (!doubtful || session_.ended()) return;
  const std::optional<canopen::Frame> request = sdo_.unanswered();
  if (answers(kAttempts) || session_.ended()) return;
  gone_ = true;
  result.outcome = Outcome::Failed;
  result.reason.clear();
  const std::span<const TimedFrame> frames = session_.since(0);
  const std::span<const TimedFrame> last = frames.last(std::min(frames.size(), kMostFrames));
  Finding finding{.expected = "the node behind the check",
                  .found = "no answer to SDO requests: it is gone",
                  .frames = {last.begin(), last.end()}};
  if (request && names_its_entry(*request)) {
    const auto [index, sub_index] = multiplexor_of(*request);
    finding.subject = {index, sub_index};
    finding.found += fmt::format(" since {}, {}", what_is_asked(*request), to_text(*request));
  }
  result.findings.push_back(std::move(finding));
}

bool Runner::revive() {
  if (settings_->mode != Mode::Full || !foreign_.empty() || !settings_->allow_reset) return false;
  Context context{session_, sdo_, *eds_, *settings_, manners_};
  return context.restart(canopen::NmtCommand::ResetNode);
}

}  // namespace conformance
