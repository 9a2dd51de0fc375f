#include "tools/axisctl/runs/fidelity/sequences.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace runs {
namespace {

/// How far is looked for an event that has another place: beyond that, events are taken one for one.
constexpr std::size_t kLookAhead = 12;

/// How many events of the log and of the run stand before the next pair that is the same.
struct Step {
  std::size_t log = 1, run = 1;
};

Step step_to_next_pair(const Sequence& sequence, std::size_t i, std::size_t j) {
  for (std::size_t both = 1; both <= kLookAhead; ++both)
    for (std::size_t in_log = 0; in_log <= both; ++in_log) {
      const std::size_t in_run = both - in_log;
      if (i + in_log < sequence.log.size() && j + in_run < sequence.run.size() &&
          sequence.log[i + in_log].bytes == sequence.run[j + in_run].bytes)
        return {in_log, in_run};
    }
  return {};
}

class SequenceJudge {
 public:
  SequenceJudge(const Sequence& sequence, canopen::Duration end, bool has_times, const Assessment& assessment)
      : sequence_{sequence},
        end_{end},
        has_times_{has_times},
        times_{assessment.times},
        verdict_{assessment.verdict},
        milestones_{assessment.milestones} {}

  void run() {
    std::size_t i = 0, j = 0;
    while (i < sequence_.log.size() && j < sequence_.run.size()) {
      if (sequence_.log[i].bytes == sequence_.run[j].bytes) {
        take_pair(sequence_.log[i++], sequence_.run[j++]);
        continue;
      }
      const Step step = step_to_next_pair(sequence_, i, j);
      take_apart(i, step.log, j, step.run);
      i += step.log;
      j += step.run;
    }
    take_apart(i, sequence_.log.size() - i, j, sequence_.run.size() - j);
  }

 private:
  void take_pair(const Event& log, const Event& run) {
    verdict_.add_same(sequence_.aspect);
    milestones_.push_back({log.at, run.at, log.place, sequence_.what + ' ' + log.words});
    if (!has_times_) return;
    const canopen::Duration later = run.at - times_.there(log.at);
    if (later == canopen::Duration::zero()) return verdict_.add_same(Aspect::EventTime);
    if (std::chrono::abs(later) <= times_.band(log.at)) return verdict_.add_within(Aspect::EventTime);
    Finding finding = finding_at(log, Nature::Time);
    finding.aspect = Aspect::EventTime;
    finding.log = log.words;
    finding.run = fmt::format("{:+.3f} ms", std::chrono::duration<double, std::milli>{later}.count());
    verdict_.add(std::move(finding));
  }

  /// Events of which none is the same as that of the other side.
  void take_apart(std::size_t i, std::size_t in_log, std::size_t j, std::size_t in_run) {
    const std::size_t both = std::min(in_log, in_run);
    for (std::size_t n = 0; n < in_log; ++n) {
      const Event& event = sequence_.log[i + n];
      Finding finding = finding_at(event, n < both ? Nature::Value : Nature::Missing);
      finding.log = event.words;
      finding.run = n < both ? sequence_.run[j + n].words : "nothing";
      verdict_.add(std::move(finding));
    }
    for (std::size_t n = both; n < in_run; ++n) {
      const Event& event = sequence_.run[j + n];
      if (event.at > end_) break;
      Finding finding{
          .aspect = sequence_.aspect, .nature = Nature::Extra, .object = sequence_.object, .at = event.at};
      finding.what = sequence_.what;
      finding.log = "nothing";
      finding.run = event.words;
      verdict_.add(std::move(finding));
    }
  }

  [[nodiscard]] Finding finding_at(const Event& event, Nature nature) const {
    return {.aspect = sequence_.aspect,
            .nature = nature,
            .object = sequence_.object,
            .at = event.at,
            .place = event.place,
            .what = sequence_.what};
  }

  const Sequence& sequence_;
  canopen::Duration end_;
  bool has_times_;
  const TimeMap& times_;
  Verdict& verdict_;
  std::vector<Milestone>& milestones_;
};

}  // namespace

void judge_sequence(const Sequence& sequence, canopen::Duration end, bool has_times,
                    const Assessment& assessment) {
  SequenceJudge{sequence, end, has_times, assessment}.run();
}

}  // namespace runs
