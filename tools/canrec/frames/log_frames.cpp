#include "tools/canrec/frames/log_frames.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "record/candump.hpp"

namespace canrec {

namespace {

/// @p text as it may stand in a message: not too long, and nothing that a terminal obeys.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 50;
  std::string copy{text.substr(0, kLongest)};
  std::ranges::replace_if(
      copy, [](char letter) { return letter < ' ' || letter > '~'; }, '?');
  return text.size() > kLongest ? copy + "..." : copy;
}

}  // namespace

LogFrames::LogFrames(std::string path, std::string interface, OnDamage on_damage)
    : path_{std::move(path)},
      interface_{std::move(interface)},
      is_chosen_{!interface_.empty()},
      on_damage_{std::move(on_damage)},
      file_{path_} {}

Expected<std::unique_ptr<LogFrames>> LogFrames::open(const std::string& path, std::string interface,
                                                     OnDamage on_damage) {
  std::error_code error;
  const auto kind = std::filesystem::status(path, error).type();
  if (kind == std::filesystem::file_type::not_found)
    return fail(Status::Failed, path + ": No such file or directory");
  if (error) return fail(Status::Failed, fmt::format("{}: {}", path, error.message()));
  if (kind != std::filesystem::file_type::regular)
    return fail(Status::Failed, path + ": expected a log of candump, this is no regular file");
  std::unique_ptr<LogFrames> log{new LogFrames{path, std::move(interface), std::move(on_damage)}};
  if (!log->file_.is_open()) return fail(Status::Failed, fmt::format("{}: {}", path, std::strerror(errno)));
  return log;
}

/// False at the end of the file.
bool LogFrames::read_line() {
  file_.getline(line_.data(), static_cast<std::streamsize>(line_.size()));
  auto length = static_cast<std::size_t>(file_.gcount());
  is_too_long_ = file_.fail() && length > 0;
  if (file_.fail() && !is_too_long_) return false;
  if (is_too_long_) {
    file_.clear();
    file_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  } else if (!file_.eof()) {
    --length;  // the end of the line is counted
  }
  ++number_;
  text_ = std::string_view{line_.data(), length};
  return true;
}

std::string LogFrames::complaint(std::string_view expected) const {
  return fmt::format("{}:{}: expected {}, got \"{}\"", path_, number_, expected, shown(text_));
}

Expected<std::optional<TimedFrame>> LogFrames::next() {
  while (read_line()) {
    if (text_.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const auto line = is_too_long_ ? tl::unexpected<std::string_view>{"a line of at most 256 characters"}
                                   : record::read_candump_line(text_);
    if (!line) {
      if (!on_damage_) return fail(Status::Damaged, complaint(line.error()));
      ++damaged_;
      on_damage_(complaint(line.error()));
      continue;
    }
    if (interface_.empty()) interface_ = line->interface;
    if (line->interface == interface_) return TimedFrame{line->at, line->frame};
    if (!is_chosen_)
      return fail(Status::Usage,
                  complaint(fmt::format("the interface {} of the lines before, unless --interface names one",
                                        interface_)));
  }
  if (file_.bad()) return fail(Status::Failed, fmt::format("{}: {}", path_, std::strerror(errno)));
  return std::nullopt;
}

}  // namespace canrec
