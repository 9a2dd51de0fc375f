#include "tools/axisctl/runs/fidelity/answers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "meaning/words.hpp"
#include "tools/axisctl/runs/fidelity/measured_value.hpp"
#include "tools/canopen-check/core/sdo_client.hpp"

namespace runs {
namespace {

namespace sdo = canopen::sdo;
using Passages = std::vector<const Passage*>;

/// A request, and what came for it.
struct Exchange {
  const Passage* request = nullptr;
  Passages answers{};
};

std::vector<Exchange> exchanges_of(const Course& course) {
  std::vector<Exchange> exchanges;
  std::map<meaning::SdoChannel, std::size_t> open;
  for (const Passage& passage : course.passages) {
    const meaning::SdoChannel channel{passage.meaning.node, passage.meaning.number};
    if (passage.meaning.role == meaning::Role::SdoRequest && passage.is_of_master) {
      open[channel] = exchanges.size();
      exchanges.push_back({.request = &passage});
    } else if (passage.meaning.role == meaning::Role::SdoResponse && open.contains(channel)) {
      exchanges[open[channel]].answers.push_back(&passage);
    }
  }
  return exchanges;
}

AnswerTimes times_of(std::vector<canopen::Duration> times) {
  std::ranges::sort(times);
  const std::size_t last = times.size() - 1;
  return {.median = times[last / 2], .most_of = times[last * 99 / 100], .longest = times[last]};
}

/// Judges the exchanges of two courses one by one.
class AnswerJudge {
 public:
  explicit AnswerJudge(const Assessment& assessment)
      : yardstick_{assessment.yardstick},
        extents_{assessment.extents},
        times_{assessment.times},
        verdict_{assessment.verdict} {}

  /// The last request of a log may be answered behind its end.
  void judge(const Exchange& log, const Exchange& run, bool is_last) {
    if (log.answers.empty() && (run.answers.empty() || is_last)) return;
    if (log.answers.empty()) return add(log, Nature::Extra, "no answer", text_of(run));
    if (run.answers.empty()) return add(log, Nature::Missing, text_of(log), "no answer");
    judge_content(log, run);
    const canopen::Duration log_time = log.answers.front()->at - log.request->at;
    const canopen::Duration run_time = run.answers.front()->at - run.request->at;
    log_times_.push_back(log_time);
    run_times_.push_back(run_time);
    judge_time(log, log_time, run_time);
  }

  void conclude(bool has_times) {
    if (run_times_.empty()) return;
    verdict_.fidelity().run_times = times_of(run_times_);
    if (has_times) verdict_.fidelity().log_times = times_of(log_times_);
  }
  void leave_out_times() noexcept { judges_times_ = false; }

 private:
  void judge_content(const Exchange& log, const Exchange& run) {
    const canopen::Frame &wanted = log.answers.front()->frame, &found = run.answers.front()->frame;
    const bool is_refused = conformance::abort_code(wanted) || conformance::abort_code(found);
    const bool is_same = std::ranges::equal(log.answers, run.answers, {}, &Passage::frame, &Passage::frame);
    if (is_same) return verdict_.add_same(Aspect::Answer);
    if (!is_refused && log.answers.size() == 1 && run.answers.size() == 1 && is_within(wanted, found))
      return verdict_.add_within(Aspect::Answer);
    add(log, is_refused ? Nature::Refusal : Nature::Value, text_of(log), text_of(run));
  }

  /// True if both tell values of one object that is measured, close enough to each other.
  [[nodiscard]] bool is_within(const canopen::Frame& wanted, const canopen::Frame& found) const {
    const unsigned bytes = meaning::expedited_bytes(wanted);
    const sdo::Address at = sdo::address_in(wanted), there = sdo::address_in(found);
    const auto band = yardstick_.bands.of(at);
    if (!band || bytes == 0 || bytes != meaning::expedited_bytes(found) || at.index != there.index ||
        at.sub_index != there.sub_index)
      return false;
    const double one = measured_value(at, std::span{wanted.data}.subspan(4, bytes), yardstick_.description);
    const double other = measured_value(at, std::span{found.data}.subspan(4, bytes), yardstick_.description);
    return std::abs(one - other) <= extents_.tolerance(at, *band);
  }

  void judge_time(const Exchange& log, canopen::Duration log_time, canopen::Duration run_time) {
    if (!judges_times_) return;
    const canopen::Duration later = run_time - times_.length_there(log_time);
    if (later == canopen::Duration::zero()) return verdict_.add_same(Aspect::AnswerTime);
    if (std::chrono::abs(later) <= yardstick_.time) return verdict_.add_within(Aspect::AnswerTime);
    Finding finding = finding_of(log, Nature::Time);
    finding.aspect = Aspect::AnswerTime;
    finding.log = milliseconds_text(log_time);
    finding.run = milliseconds_text(run_time);
    verdict_.add(std::move(finding));
  }

  static std::string milliseconds_text(canopen::Duration time) {
    return fmt::format("{:.3f} ms", std::chrono::duration<double, std::milli>{time}.count());
  }

  [[nodiscard]] std::string text_of(const Exchange& exchange) const {
    const Passage& first = *exchange.answers.front();
    std::string text = meaning::words_of(first.frame, first.meaning, yardstick_.description);
    if (const std::size_t colon = text.find(": "); colon != std::string::npos) text.erase(0, colon + 2);
    for (std::size_t i = 1; i < exchange.answers.size() && i < 4; ++i)
      text += ' ' + conformance::to_text(exchange.answers[i]->frame);
    return exchange.answers.size() > 4 ? fmt::format("{} ({} frames)", text, exchange.answers.size()) : text;
  }

  [[nodiscard]] Finding finding_of(const Exchange& log, Nature nature) const {
    const Passage& request = *log.request;
    Finding finding{.nature = nature, .at = request.at, .place = request.place};
    const auto kind = sdo::CommandByte{request.frame.data[0]}.request();
    if (kind == sdo::Request::InitiateDownload || kind == sdo::Request::InitiateUpload)
      finding.object = sdo::address_in(request.frame);
    finding.what = meaning::words_of(request.frame, request.meaning, yardstick_.description);
    return finding;
  }

  void add(const Exchange& log, Nature nature, std::string wanted, std::string found) {
    Finding finding = finding_of(log, nature);
    finding.log = std::move(wanted);
    finding.run = std::move(found);
    verdict_.add(std::move(finding));
  }

  const Yardstick& yardstick_;
  const Extents& extents_;
  const TimeMap& times_;
  Verdict& verdict_;
  std::vector<canopen::Duration> log_times_, run_times_;
  bool judges_times_ = true;
};

}  // namespace

void note_answers(const Course& log, const Yardstick& yardstick, Extents& extents) {
  for (const Passage& passage : log.passages) {
    const unsigned bytes =
        passage.meaning.role == meaning::Role::SdoResponse ? meaning::expedited_bytes(passage.frame) : 0;
    if (bytes == 0) continue;
    const sdo::Address at = sdo::address_in(passage.frame);
    if (yardstick.bands.of(at))
      extents.note(at, measured_value(at, std::span{passage.frame.data}.subspan(4, bytes), yardstick.description));
  }
}

void judge_answers(const Course& log, const Course& run, const Assessment& assessment) {
  const std::vector<Exchange> wanted = exchanges_of(log), found = exchanges_of(run);
  AnswerJudge judge{assessment};
  if (!log.has_times) judge.leave_out_times();
  for (std::size_t i = 0; i < std::min(wanted.size(), found.size()); ++i) {
    judge.judge(wanted[i], found[i], i + 1 == wanted.size());
    if (wanted[i].answers.empty() || found[i].answers.empty()) continue;
    const Passage& answer = *wanted[i].answers.front();
    const Passage& request = *wanted[i].request;
    assessment.milestones.push_back(
        {answer.at, found[i].answers.front()->at, answer.place,
         "the answer to " + meaning::words_of(request.frame, request.meaning, assessment.yardstick.description)});
  }
  judge.conclude(log.has_times);
}

}  // namespace runs
