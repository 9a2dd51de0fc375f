#include "tools/canrec/frames/transcript.hpp"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "can/hub/trunk/lateness.hpp"
#include "can/hub/trunk/message.hpp"

namespace canrec {

using hub::trunk::Hubs;
using hub::trunk::Reader;

void Transcript::take(const Message& message, std::vector<TimedFrame>& frames) {
  std::string_view problem;
  const auto reader = Reader::read(message.bytes, problem);
  if (!reader) {
    ++figures_.malformed;
    return;
  }
  const auto& header = reader->header();
  const bool is_late = hub::trunk::is_late(header, message.at.count());
  if (is_overruled(header, is_late) || hubs_.is_outdated(header)) {
    figures_.late += reader->frames();
    return;
  }
  const std::uint64_t missed = hubs_.missed();
  const Hubs::Outcome outcome = hubs_.note(header, reader->frames(), canopen::TimePoint{message.at});
  figures_.missed = hubs_.missed();
  if (hubs_.missed() != missed) ++figures_.gaps;
  figures_.repeated += outcome.repeated;
  const std::chrono::nanoseconds at{reader->time(message.at.count())};
  for (std::size_t i = outcome.repeated; i < reader->frames(); ++i) {
    const hub::trunk::MarkedFrame marked = reader->frame(i);
    if (is_late) {
      ++figures_.late;
    } else if (!origins_.is_new({.hub = header.origin, .number = marked.number})) {
      ++figures_.repeated;
    } else {
      ++figures_.frames;
      frames.push_back({message.log_time.value_or(at), marked.frame});
    }
  }
}

/// Whose term it is shows within 100 ms; until then whoever lets frames pass is believed.
bool Transcript::is_overruled(const hub::trunk::Header& header, bool is_late) noexcept {
  using Verdict = hub::trunk::Terms::Verdict;
  if (!is_of_arbiter(header.kind)) return false;
  const bool is_known = terms_.term() != 0;
  const Verdict verdict = terms_.judge(header, is_late);
  return verdict == Verdict::End || (verdict == Verdict::Ignore && is_known);
}

std::string Transcript::text() const {
  std::string text = fmt::format("{} frames, ", figures_.frames);
  text += figures_.missed == 0 ? "none missed"
                               : fmt::format("{} missed in {} gap{}", figures_.missed, figures_.gaps,
                                             figures_.gaps == 1 ? "" : "s");
  struct Row {
    std::uint64_t count;
    std::string_view what;
  };
  std::string_view separator = "; ";
  for (const Row& row : {Row{figures_.late, "late"}, Row{figures_.repeated, "repeated"},
                         Row{figures_.malformed, "messages that are none of a hub"}}) {
    if (row.count == 0) continue;
    text += fmt::format("{}{} {}", separator, row.count, row.what);
    separator = ", ";
  }
  return text;
}

}  // namespace canrec
