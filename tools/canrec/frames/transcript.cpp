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
  if (hubs_.is_outdated(header)) {
    figures_.late += reader->frames();
    return;
  }
  const std::uint64_t missed = hubs_.missed();
  const Hubs::Outcome outcome = hubs_.note(header, reader->frames(), canopen::TimePoint{message.at});
  figures_.missed = hubs_.missed();
  if (hubs_.missed() != missed) ++figures_.gaps;
  figures_.repeated += outcome.repeated;
  for (std::size_t i = outcome.repeated; i < reader->frames(); ++i) {
    const hub::trunk::MarkedFrame marked = reader->frame(i);
    if (is_late) {
      ++figures_.late;
    } else if (!origins_.is_new({.hub = header.origin, .number = marked.number})) {
      ++figures_.repeated;
    } else {
      ++figures_.frames;
      frames.push_back({message.log_time.value_or(message.at), marked.frame});
    }
  }
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
