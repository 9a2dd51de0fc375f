#include "tools/axisctl/scenario/run/run.hpp"

#include <algorithm>
#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "can/port/address.hpp"
#include "os/clock.hpp"
#include "tools/axisctl/scenario/run/actions.hpp"
#include "tools/axisctl/scenario/run/capture.hpp"
#include "tools/axisctl/scenario/run/fault_load.hpp"
#include "tools/axisctl/scenario/run/watches.hpp"

namespace scenario {
namespace {

/// Frames in the report of a failure.
constexpr std::size_t kLastFrames = 30;

double seconds_of(canopen::Duration time) noexcept {
  return std::chrono::duration<double>{time}.count();
}

/// The steps of one scenario, on a bus with its stations.
class Course {
 public:
  Course(Context& context, RunResult& result) : context_{context}, result_{result} {
    for (const Step& step : context.scenario.steps) result.steps.push_back({.step = &step});
    begin_ = last_ = context.bench.now();
    context.bench.on_look([this] { return look(); });
  }
  ~Course() { context_.bench.on_look({}); }
  Course(const Course&) = delete;
  Course& operator=(const Course&) = delete;

  /// True if all has gone as it has to.
  bool run() {
    for (StepResult& step : result_.steps)
      if (!run_step(step)) return false;
    return end();
  }
  [[nodiscard]] canopen::TimePoint begin() const noexcept { return begin_; }

 private:
  bool run_step(StepResult& result) {
    current_ = &result;
    const Step& step = *result.step;
    const Outcome begun = wait_for_begin(step);
    if (const std::string name = step.keys.value("name", ""); !name.empty()) watches_.end_before(name);
    const canopen::TimePoint begin = context_.bench.now();
    result.begin_s = seconds_of(begin - begin_);
    const Outcome outcome = begun ? do_step(step) : begun;
    last_ = context_.bench.now();
    result.took_s = seconds_of(last_ - begin);
    if (!trouble_ && context_.bench.interrupted()) (void)look();
    if (!trouble_ && context_.bench.interrupted()) trouble_ = "the bus is down, or has carried too many frames";
    const bool is_good = outcome && !trouble_ && result.kind != StepResult::Kind::Failed;
    if (is_good) {
      result.kind = StepResult::Kind::Passed;
      result.text = *outcome;
    } else if (violated_ == nullptr || violated_ == &result) {
      result.kind = StepResult::Kind::Failed;
      result.text = trouble_ ? *trouble_ : outcome ? result.text : outcome.error();
    } else {
      result.text = "not finished";
    }
    return is_good;
  }

  Outcome wait_for_begin(const Step& step) {
    if (step.keys.contains("at_ms")) context_.bench.pass(begin_ + milliseconds(step.keys.at("at_ms")));
    if (step.keys.contains("after_ms")) context_.bench.pass(last_ + milliseconds(step.keys.at("after_ms")));
    if (!step.keys.contains("on")) return std::string{};
    Outcome outcome = wait_for(context_, condition_of(step.keys.at("on")), milliseconds(kUsualWait));
    if (!outcome) return tl::unexpected{"it has not begun: " + outcome.error()};
    return outcome;
  }

  Outcome do_step(const Step& step) {
    if (step.action->key.form != Form::State && step.action->key.key != "never") return act(context_, step);
    watches_.add(step, context_.bench.frames().size());
    if (!step.keys.contains("for_ms")) return "watched from here on";
    context_.bench.pass(context_.bench.now() + milliseconds(step.keys.at("for_ms")));
    (void)look();
    watches_.end(step);
    return std::string{};
  }

  /// The end of all steps: what was watched holds still, and programs have ended as they have to.
  bool end() {
    for (const auto& program : context_.stations.programs()) {
      if (!program->plan.exit_status || !program->process) continue;
      const Condition condition =
          condition_of({{"ended", program->plan.name}, {"exit_status", *program->plan.exit_status}});
      const Outcome outcome = wait_for(context_, condition, milliseconds(kUsualWait));
      if (!outcome) trouble_ = fmt::format("program {}: {}", program->plan.name, outcome.error());
    }
    if (!trouble_) (void)look();
    if (trouble_ && violated_ == nullptr) result_.problem = *trouble_;
    return !trouble_;
  }

  /// Between frames: false if the run is to end.
  bool look() {
    if (is_looking_ || trouble_) return !trouble_;
    is_looking_ = true;
    const double limit = context_.scenario.limit_s;
    if (taken_signal() != 0) {
      result_.interrupted = true;
      trouble_ = "interrupted";
    } else if (seconds_of(context_.bench.now() - begin_) > limit) {
      trouble_ = fmt::format("step {} was waited for when the scenario had taken {} s, its limit",
                             current_ == nullptr ? 0 : current_->step->number, limit);
    } else if (auto lost = context_.stations.find_lost()) {
      trouble_ = std::move(lost);
    } else if (auto violation = watches_.look(context_)) {
      blame(*violation);
    }
    is_looking_ = false;
    return !trouble_;
  }

  void blame(const Watches::Violation& violation) {
    const auto result = std::ranges::find(result_.steps, violation.step, &StepResult::step);
    result->kind = StepResult::Kind::Failed;
    result->text = fmt::format("{} at {:.3f} s, in step {}", violation.text,
                               seconds_of(context_.bench.now() - begin_), current_->step->number);
    violated_ = &*result;
    trouble_ = result->text;
  }

  Context& context_;
  RunResult& result_;
  Watches watches_;
  canopen::TimePoint begin_{}, last_{};
  StepResult* current_ = nullptr;
  StepResult* violated_ = nullptr;
  std::optional<std::string> trouble_{};
  bool is_looking_ = false;
};

void keep_last_frames(const Bench& bench, canopen::TimePoint begin, RunResult& result) {
  const auto& frames = bench.frames();
  const std::size_t count = std::min(frames.size(), kLastFrames);
  result.frames.assign(frames.end() - static_cast<std::ptrdiff_t>(count), frames.end());
  for (TimedFrame& frame : result.frames) frame.time = canopen::TimePoint{frame.time - begin};
}

/// What those who take part have printed last, and what has come of the faults.
void take_notes(Context& context, RunResult& result) {
  for (const auto& program : context.stations.programs())
    if (program->process)
      if (const std::string line = program->process->last_line(); !line.empty())
        result.notes.push_back(fmt::format("{}: {}", program->plan.name, line));
  for (const auto& [name, fault] : context.faults)
    if (auto state = state_of_fault(context, name)) {
      (*state)["name"] = name;
      result.faults.push_back(*std::move(state));
    }
}

tl::expected<void, std::string> run_on(Stations& stations, const Scenario& scenario, RunResult& result) {
  if (auto started = stations.start_bus(); !started) return started;
  result.bus = stations.bus();
  Bench bench{bus::open(*bus::parse_address(stations.bus())), stations.time()};
  Context context{.scenario = scenario, .bench = bench, .stations = stations};
  for (const nlohmann::json& fault : scenario.bus_faults)
    if (const auto loaded = load_fault(context, {}, fault); !loaded) return tl::unexpected{loaded.error()};
  if (auto started = stations.start_units(bench); !started) return started;
  if (auto started = stations.start_programs(); !started) return started;
  Course course{context, result};
  result.begin = os::wall_time() - (bench.now() - course.begin());
  result.passed = course.run();
  result.seconds = seconds_of(bench.now() - course.begin());
  take_notes(context, result);
  keep_last_frames(bench, course.begin(), result);
  return {};
}

}  // namespace

RunResult run(const Scenario& scenario, const RunOptions& options) {
  RunResult result;
  const auto workshop = Workshop::open(options.keep);
  if (!workshop) {
    result.problem = workshop.error();
    return result;
  }
  result.folder = workshop->folder();
  try {
    const bool is_recorded = options.captured != Captured::None;
    Stations stations{scenario,
                      *workshop,
                      {.address = options.bus, .time = options.time},
                      is_recorded ? Recorded::Yes : Recorded::No};
    const auto checked = stations.check_units();
    result.bad_input = !checked;
    const auto ran = checked ? run_on(stations, scenario, result) : checked;
    if (!ran) result.problem = ran.error();
    result.is_captured = checked && (options.captured == Captured::All || (is_recorded && !result.passed));
    if (result.is_captured) result.units = capture(stations, scenario, *workshop);
  } catch (const bus::OpenError& error) {
    result.problem = error.what();
  }
  return result;
}

}  // namespace scenario
