#include "tools/canopen-check/core/run/runner.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "libcanopen/od/abort_code.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

/// Requests for 1000h:00 until a node counts as absent.
constexpr int kAttempts = 3;

}  // namespace

std::size_t RunReport::count(Outcome outcome) const noexcept {
  return static_cast<std::size_t>(std::ranges::count(results, outcome, &CheckResult::outcome));
}

Runner::Runner(Wire& wire, const eds::Description& eds, const Settings& settings, Deviations& deviations)
    : session_{wire, settings.node_id},
      sdo_{session_, session_.identifier(function_code::kSdoRequest),
           session_.identifier(function_code::kSdoResponse), settings.patience},
      eds_{&eds},
      settings_{&settings},
      deviations_{&deviations} {}

std::string Runner::trouble() const {
  if (!session_.bus_is_up()) return "the bus is down";
  if (session_.interrupted()) return "interrupted";
  return over_;
}

bool Runner::reach(RunReport& report) {
  report.reached = answers(kAttempts);
  if (!report.reached && settings_->mode == Mode::Full && !session_.ended()) {
    // A stopped node answers no SDO.
    session_.command(canopen::NmtCommand::EnterPreOperational);
    report.reached = answers(kAttempts);
    initial_state_ = canopen::NmtState::Stopped;
  }
  if (!report.reached)
    report.problem =
        session_.ended()
            ? trouble()
            : fmt::format("node {} does not answer an upload of 1000h:00 (request {:03X}h, {})",
                          session_.node_id(), sdo_.request_identifier(), milliseconds(settings_->patience));
  return report.reached;
}

std::string Runner::foreign_device() {
  const eds::DeviceFacts& device = eds_->device();
  std::uint8_t sub = 0;
  for (const std::optional<std::uint64_t>& stated : {device.vendor, device.product}) {
    ++sub;
    if (stated.value_or(0) == 0) continue;
    const SdoAnswer answer = sdo_.upload(object::kIdentity, sub);
    if (answer.done() && answer.number() != *stated)
      return fmt::format(
          "the EDS is of another device: 1018h:{:02X} is {:08X}h, the EDS says {:08X}h; nothing is written", sub,
          answer.number(), *stated);
  }
  return {};
}

void Runner::explore() {
  Context context{session_, sdo_, *eds_, *settings_, manners_};
  if (initial_state_ != canopen::NmtState::Stopped && context.observe_state())
    initial_state_ = context.state().value_or(initial_state_);
  session_.clean_up(true);
  session_.command(canopen::NmtCommand::EnterPreOperational);
  (void)context.undo().restore();
  session_.clean_up(false);
}

RunReport Runner::run(std::span<const Check* const> checks, const Progress& progress) {
  RunReport report;
  const canopen::TimePoint begin = session_.now();
  if (!settings_->allow_reset) session_.forbid_resets();
  if (!reach(report)) {
    report.time = session_.now() - begin;
    return report;
  }
  foreign_ = foreign_device();
  report.problem = foreign_;
  sdo_.learn_aborts();
  const bool changes = settings_->mode == Mode::Full && foreign_.empty();
  if (changes) explore();
  Snapshot snapshot{sdo_, changes ? *eds_ : eds::Description{}, *settings_};
  std::size_t number = 0;
  for (const Check* check : checks)
    if (why_not(*check).empty()) manners_.ahead.insert(check->id);
  for (const Check* check : checks) {
    if (!over_.empty()) {
      report.results.push_back({.check = check, .outcome = Outcome::Skipped, .reason = over_});
      continue;
    }
    progress.begin(*check, ++number, checks.size());
    manners_.ahead.erase(check->id);
    report.results.push_back(run_check(*check));
    progress.end(report.results.back());
    over_ = consequence(*check, report);
  }
  if (number < checks.size()) progress.left_out(checks.size() - number, over_);
  if (changes) finish(report, snapshot);
  report.cut_short = !over_.empty() || session_.ended();
  if (report.cut_short) report.problem = over_.empty() ? trouble() : over_;
  if (sdo_.strays() != 0)
    report.notes.push_back(fmt::format("{} frames of the SDO server answered no request, the first: {}",
                                       sdo_.strays(), sdo_.first_stray()));
  report.time = session_.now() - begin;
  return report;
}

void Runner::take_over() {
  sdo_.ask_again();
  session_.clean_up(true);
  // An interruption leaves a transfer open; a server in the middle of a block takes requests for segments.
  sdo_.abort(0, 0, static_cast<std::uint32_t>(canopen::AbortCode::GeneralError));
  session_.command(canopen::NmtCommand::EnterPreOperational);
}

void Runner::finish(RunReport& report, Snapshot& snapshot) {
  if (gone_ || !session_.bus_is_up()) {
    report.not_restored.push_back(over_ + ", and nothing could be compared with what was there before");
    return;
  }
  take_over();
  report.not_restored = snapshot.restore();
  store_again(report);
  if (initial_state_ == canopen::NmtState::Operational) session_.command(canopen::NmtCommand::Start);
  if (initial_state_ == canopen::NmtState::Stopped) session_.command(canopen::NmtCommand::Stop);
  report.notes.push_back(
      fmt::format("{} writable entries were read before and compared afterwards", snapshot.size()));
}

void Runner::store_again(RunReport& report) {
  constexpr std::array<std::uint8_t, 4> kSave{'s', 'a', 'v', 'e'};
  const bool stored = std::ranges::any_of(report.results, [](const CheckResult& result) {
    return result.check->stores && result.outcome != Outcome::Skipped;
  });
  if (!stored) return;
  const SdoAnswer answer = sdo_.download(object::kStoreParameters, 1, kSave);
  report.notes.push_back(answer.done() ? "what the node works with was stored by 1010h:01"
                                       : "what the node works with could not be stored: " + to_text(answer));
}

std::string Runner::why_not(const Check& check) const {
  if (check.mode == Mode::Full && !foreign_.empty()) return foreign_;
  if (check.mode > settings_->mode) return "it changes the node: needs --full";
  if (check.stores && !settings_->allow_store) return "needs --allow-store";
  if (std::ranges::any_of(settings_->skip, [&](const std::string& word) { return is_named(check, word); }))
    return "left out by --skip";
  if (check.moves && !settings_->allow_motion) return "needs --allow-motion";
  return {};
}

CheckResult Runner::run_check(const Check& check) {
  CheckResult result{.check = &check};
  result.reason = why_not(check);
  if (!result.reason.empty()) {
    result.outcome = Outcome::Skipped;
    return result;
  }
  const canopen::TimePoint begin = session_.now();
  const std::size_t strays = sdo_.strays();
  perform(check, result);
  judge_operational(check, result);
  judge_presence(result);
  if (strays == 0 && sdo_.strays() != 0)
    result.notes.push_back("a frame of the SDO server that answers no request is ignored: " + sdo_.first_stray());
  result.time = session_.now() - begin;
  deviations_->judge(result);
  return result;
}

void Runner::perform(const Check& check, CheckResult& result) {
  sdo_.settle();
  session_.drain();  // what comes late belongs to the check before
  session_.forget();
  sdo_.ask_again();
  if (check.mode == Mode::Full) session_.command(canopen::NmtCommand::EnterPreOperational);
  Context context{session_, sdo_, *eds_, *settings_, manners_};
  check.run(context);
  const bool ended = session_.ended();
  was_operational_ = context.was_operational();
  result.findings = std::move(context.findings());
  result.notes = std::move(context.notes());
  if (was_operational_ && !manners_.refuses_operational.empty()) {
    result.findings.clear();  // of what follows from another state
    context.skip(manners_.refuses_operational);
  }
  if (result.findings.empty() && context.skipped()) {
    result.outcome = Outcome::Skipped;
    result.reason = *context.skipped();
  } else if (!result.findings.empty()) {
    result.outcome = Outcome::Failed;
  }
  if (check.mode == Mode::Full) restore(context, result);
  if (!ended) return;
  result.findings.clear();  // of frames that could not come any more
  result.outcome = Outcome::Broken;
  result.reason = trouble();
}

void Runner::restore(Context& context, CheckResult& result) {
  take_over();
  for (std::string& line : context.undo().restore())
    result.notes.push_back("not restored at the end of this check: " + std::move(line));
  session_.clean_up(false);
}

}  // namespace conformance
