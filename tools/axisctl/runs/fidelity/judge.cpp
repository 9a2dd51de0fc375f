#include "tools/axisctl/runs/fidelity/judge.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "meaning/words.hpp"
#include "tools/axisctl/runs/fidelity/answers.hpp"
#include "tools/axisctl/runs/fidelity/pdo_values.hpp"
#include "tools/axisctl/runs/fidelity/sequences.hpp"
#include "tools/canopen-check/core/sdo_client.hpp"

namespace runs {
namespace {

constexpr std::uint8_t kToggle = 0x80;

/// A source of events: an identifier's meaning, in the log and in the run.
using Events = std::map<meaning::Meaning, std::vector<Event>>;

/// Words without whose they are.
std::string short_words(const Passage& passage, const Yardstick& yardstick) {
  std::string words = meaning::words_of(passage.frame, passage.meaning, yardstick.description);
  if (const std::size_t colon = words.find(": "); colon != std::string::npos) return words.substr(colon + 2);
  return words.substr(0, words.find(" of node"));
}

/// Every emergency message of @p course.
Events emergencies_of(const Course& course, const Yardstick& yardstick) {
  Events events;
  for (const Passage& passage : course.passages) {
    if (passage.meaning.role != meaning::Role::Emergency || passage.is_of_master) continue;
    const auto& data = passage.frame.data;
    events[passage.meaning].push_back(
        {.at = passage.at,
         .place = passage.place,
         .bytes = {data.begin(), data.begin() + passage.frame.length},
         .words = fmt::format("{} ({})", short_words(passage, yardstick), conformance::to_text(passage.frame))});
  }
  return events;
}

/// The NMT states that error control tells, each once, and every boot-up message.
Events states_of(const Course& course, const Yardstick& yardstick) {
  Events events;
  for (const Passage& passage : course.passages) {
    if (passage.meaning.role != meaning::Role::ErrorControl || passage.is_of_master || passage.frame.length != 1)
      continue;
    const auto state = static_cast<std::uint8_t>(passage.frame.data[0] & ~kToggle);
    std::vector<Event>& former = events[passage.meaning];
    if (state != 0 && !former.empty() && former.back().bytes.front() == state) continue;
    former.push_back({passage.at, passage.place, {state}, short_words(passage, yardstick)});
  }
  return events;
}

/// The words of TPDOs, each time they change.
Events words_of_pdos(const PdoImages& images) {
  Events events;
  for (const auto& [pdo, frames] : images)
    for (const PdoImage& image : frames) {
      std::vector<Event>& former = events[pdo];
      if (former.empty() || former.back().bytes != image.words)
        former.push_back({image.at, image.place, image.words, conformance::to_text(image.frame)});
    }
  return events;
}

class Judge {
 public:
  Judge(const Course& log, const Course& run, const Yardstick& yardstick)
      : log_{log},
        run_{run},
        yardstick_{yardstick},
        times_{log, run, yardstick, 1 / yardstick.speed},
        verdict_{yardstick.known} {
    if (log.passages.empty()) return;
    const canopen::Duration last = log.passages.back().at;
    end_ = times_.there(last);
    if (log.has_times) end_ -= times_.band(last);
  }

  Fidelity judge() {
    const PdoImages log_pdos = images_of(log_, yardstick_), run_pdos = images_of(run_, yardstick_);
    note_answers(log_, yardstick_, extents_);
    for (const auto& [pdo, images] : log_pdos)
      for (const PdoImage& image : images)
        for (const PdoImage::Measured& measured : image.measured) extents_.note(measured.object, measured.value);
    judge_answers(log_, run_, assessment());
    judge_events(Aspect::Emergency, "EMCY", emergencies_of(log_, yardstick_), emergencies_of(run_, yardstick_));
    judge_events(Aspect::State, "error control", states_of(log_, yardstick_), states_of(run_, yardstick_));
    judge_pdos(log_pdos, run_pdos);
    judge_order(std::move(milestones_), times_, verdict_);
    std::ranges::stable_sort(verdict_.fidelity().findings, {}, &Finding::at);
    return std::move(verdict_.fidelity());
  }

 private:
  void judge_events(Aspect aspect, std::string_view what, Events log, Events run) {
    std::set<meaning::Meaning> sources;
    for (const Events* const events : {&log, &run})
      for (const auto& [source, ignored] : *events) sources.insert(source);
    for (const meaning::Meaning& source : sources)
      judge_one({.aspect = aspect,
                 .what = fmt::format("{} of node {}", what, source.node),
                 .log = std::move(log[source]),
                 .run = std::move(run[source])});
  }

  void judge_pdos(const PdoImages& log, const PdoImages& run) {
    Events wanted = words_of_pdos(log), found = words_of_pdos(run);
    std::set<meaning::Meaning> pdos;
    for (const PdoImages* const images : {&log, &run})
      for (const auto& [pdo, ignored] : *images) pdos.insert(pdo);
    static const std::vector<PdoImage> kNone;
    for (const meaning::Meaning& pdo : pdos) {
      const auto in_log = log.find(pdo), in_run = run.find(pdo);
      const std::vector<PdoImage>& images = in_log == log.end() ? kNone : in_log->second;
      Sequence sequence{.aspect = Aspect::PdoWord,
                        .what = fmt::format("TPDO {} of node {}", pdo.number, pdo.node),
                        .log = std::move(wanted[pdo]),
                        .run = std::move(found[pdo])};
      if (!images.empty()) sequence.object = images.front().object;
      judge_values({sequence.what, images, in_run == run.end() ? kNone : in_run->second}, back_, assessment());
      judge_one(sequence);
    }
  }

  void judge_one(const Sequence& sequence) { judge_sequence(sequence, end_, log_.has_times, assessment()); }

  [[nodiscard]] Assessment assessment() { return {yardstick_, extents_, times_, verdict_, milestones_}; }

  const Course &log_, &run_;
  const Yardstick& yardstick_;
  TimeMap times_, back_{run_, log_, yardstick_, yardstick_.speed};  ///< from the log to the run, and back
  Verdict verdict_;
  Extents extents_{};
  std::vector<Milestone> milestones_{};
  canopen::Duration end_{};  ///< what the run has later, the log may have had behind its last frame
};

}  // namespace

Fidelity judge(const Course& log, const Course& run, const Yardstick& yardstick) {
  return Judge{log, run, yardstick}.judge();
}

}  // namespace runs
