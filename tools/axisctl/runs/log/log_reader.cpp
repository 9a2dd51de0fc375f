#include "tools/axisctl/runs/log/log_reader.hpp"

#include <array>
#include <fstream>
#include <span>

#include <fmt/format.h>

#include "can/port/wire.hpp"
#include "os/regular_file.hpp"
#include "record/candump.hpp"
#include "record/show.hpp"

namespace runs {
namespace {

bool is_recording(const std::string& path) {
  std::array<char, record::kMagic.size()> beginning{};
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream{path, std::ios::binary}.read(beginning.data(), beginning.size());
  return std::string_view{beginning.data(), beginning.size()} == record::kMagic;
}

LoggedFrame logged(const can_frame& wire, std::chrono::nanoseconds at, std::uint64_t place) {
  LoggedFrame frame{.at = at, .place = place, .frame = bus::from_wire(wire)};
  frame.is_error = (wire.can_id & CAN_ERR_FLAG) != 0;
  if (frame.is_error) frame.frame.id = wire.can_id & CAN_ERR_MASK;
  return frame;
}

}  // namespace

std::string text_of(const LoggedFrame& logged) {
  can_frame wire = bus::to_wire(logged.frame);
  if (logged.is_error) wire.can_id = (logged.frame.id & CAN_ERR_MASK) | CAN_ERR_FLAG;
  std::string line = record::candump_line({.interface = "can0", .frame = wire});
  line.pop_back();
  return line.substr(line.rfind(' ') + 1);
}

Expected<std::unique_ptr<LogReader>> LogReader::open(const std::string& path, std::string interface) {
  std::unique_ptr<LogReader> reader{new LogReader{path, std::move(interface)}};
  reader->is_chosen_ = !reader->interface_.empty();
  if (runs::is_recording(path)) {
    if (auto opened = reader->open_recording(); !opened) return tl::unexpected{opened.error()};
    return reader;
  }
  auto lines = record::LogLines::open(path);
  if (!lines) return fail(ExitStatus::NotThere, lines.error());
  reader->lines_.emplace(*std::move(lines));
  return reader;
}

Expected<void> LogReader::open_recording() {
  auto content = os::read_regular_file(path_, record::kLongestFile);
  if (!content) return fail(ExitStatus::NotThere, fmt::format("{}: {}", path_, content.error().reason()));
  content_ = *std::move(content);
  auto recording = record::Reader::open(std::as_bytes(std::span{content_}));
  if (!recording) return fail(ExitStatus::Damaged, fmt::format("{}: {}", path_, recording.error()));
  recording_.emplace(*std::move(recording));
  const auto wall_clock = recording_->head().find("wall_clock_ns");
  if (wall_clock != recording_->head().end() && wall_clock->is_number_integer())
    begin_ = std::chrono::nanoseconds{wall_clock->get<std::int64_t>()};
  return {};
}

Expected<std::optional<LoggedFrame>> LogReader::next() {
  return recording_ ? next_record() : next_line();
}

Expected<std::optional<LoggedFrame>> LogReader::next_line() {
  while (lines_->next()) {
    if (lines_->is_blank()) continue;
    const auto line = lines_->is_too_long() ? tl::unexpected<std::string_view>{record::kLineRule}
                                            : record::read_printed_line(lines_->text());
    if (lines_->is_open())
      remark_ = line ? fmt::format("{}:{}: the last line has no end: the log may be cut", path_, lines_->number())
                     : fmt::format("{}:{}: the log is cut within its last line, which is left out", path_,
                                   lines_->number());
    if (!line && lines_->is_open()) break;
    if (!line) return fail(ExitStatus::Damaged, lines_->complaint(line.error()));
    if (interface_.empty()) interface_ = line->line.interface;
    if (line->line.interface != interface_) {
      if (is_chosen_) continue;
      return fail(ExitStatus::Usage, lines_->complaint(fmt::format("the interface {} of the lines before, unless "
                                                                   "--of names one",
                                                                   interface_)));
    }
    if (frames_++ == 0) has_times_ = line->has_time;
    if (line->has_time != has_times_)
      return fail(ExitStatus::Damaged, lines_->complaint(has_times_ ? "a time, as in the lines before"
                                                                    : "no time, as in the lines before"));
    return logged(line->line.frame, line->line.at, lines_->number());
  }
  if (std::string failure = lines_->failure(); !failure.empty())
    return fail(ExitStatus::NotThere, std::move(failure));
  return std::nullopt;
}

std::optional<LoggedFrame> LogReader::next_record() {
  while (const auto record = recording_->next()) {
    ++records_;
    if (const auto* const lost = std::get_if<record::LostRecord>(&record->content)) lost_ += lost->records;
    const auto* const frame = std::get_if<record::FrameRecord>(&record->content);
    if (frame == nullptr) continue;
    return LoggedFrame{.at = begin_ + record->at,
                       .place = records_,
                       .frame = frame->frame,
                       .sender = frame->sent ? Sender::Unit : Sender::Others};
  }
  if (const std::string remark = recording_->remark(); !remark.empty())
    remark_ = fmt::format("{}: {}", path_, remark);
  return std::nullopt;
}

}  // namespace runs
