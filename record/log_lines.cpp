#include "record/log_lines.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <system_error>

#include <fmt/format.h>

namespace record {
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

tl::expected<LogLines, std::string> LogLines::open(const std::string& path) {
  std::error_code error;
  const auto kind = std::filesystem::status(path, error).type();
  if (kind == std::filesystem::file_type::not_found) return tl::unexpected{path + ": No such file or directory"};
  if (error) return tl::unexpected{fmt::format("{}: {}", path, error.message())};
  if (kind != std::filesystem::file_type::regular)
    return tl::unexpected{path + ": expected a log of candump, this is no regular file"};
  LogLines lines{path};
  if (!lines.file_.is_open()) return tl::unexpected{fmt::format("{}: {}", path, std::strerror(errno))};
  return lines;
}

bool LogLines::next() {
  file_.getline(line_.data(), static_cast<std::streamsize>(line_.size()));
  length_ = static_cast<std::size_t>(file_.gcount());
  is_too_long_ = file_.fail() && length_ > 0;
  if (file_.fail() && !is_too_long_) return false;
  if (is_too_long_) {
    file_.clear();
    file_.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  } else if (!file_.eof()) {
    --length_;  // the end of the line is counted
  }
  is_open_ = file_.eof();
  ++number_;
  return true;
}

bool LogLines::is_blank() const noexcept {
  return std::ranges::all_of(text(),
                             [](char letter) { return letter == ' ' || letter == '\t' || letter == '\r'; });
}

std::string LogLines::failure() const {
  return file_.bad() ? fmt::format("{}: {}", path_, std::strerror(errno)) : std::string{};
}

std::string LogLines::complaint(std::string_view expected) const {
  return fmt::format("{}:{}: expected {}, got \"{}\"", path_, number_, expected, shown(text()));
}

}  // namespace record
