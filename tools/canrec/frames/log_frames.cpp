#include "tools/canrec/frames/log_frames.hpp"

#include <utility>

#include <fmt/format.h>

#include "record/candump.hpp"

namespace canrec {

LogFrames::LogFrames(record::LogLines lines, std::string interface, OnDamage on_damage)
    : lines_{std::move(lines)},
      interface_{std::move(interface)},
      is_chosen_{!interface_.empty()},
      on_damage_{std::move(on_damage)} {}

Expected<std::unique_ptr<LogFrames>> LogFrames::open(const std::string& path, std::string interface,
                                                     OnDamage on_damage) {
  auto lines = record::LogLines::open(path);
  if (!lines) return fail(Status::Failed, lines.error());
  return std::unique_ptr<LogFrames>{new LogFrames{*std::move(lines), std::move(interface), std::move(on_damage)}};
}

Expected<std::optional<TimedFrame>> LogFrames::next() {
  while (lines_.next()) {
    if (lines_.is_blank()) continue;
    const auto line = lines_.is_too_long() ? tl::unexpected<std::string_view>{record::kLineRule}
                                           : record::read_candump_line(lines_.text());
    if (!line) {
      if (!on_damage_) return fail(Status::Damaged, lines_.complaint(line.error()));
      ++damaged_;
      on_damage_(lines_.complaint(line.error()));
      continue;
    }
    if (interface_.empty()) interface_ = line->interface;
    if (line->interface == interface_) return TimedFrame{line->at, line->frame};
    if (!is_chosen_)
      return fail(Status::Usage,
                  lines_.complaint(fmt::format(
                      "the interface {} of the lines before, unless --interface names one", interface_)));
  }
  if (std::string failure = lines_.failure(); !failure.empty()) return fail(Status::Failed, std::move(failure));
  return std::nullopt;
}

}  // namespace canrec
