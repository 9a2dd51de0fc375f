#include "record/segments.hpp"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

#include "checksum/crc32.hpp"
#include "record/candump.hpp"
#include "record/reader.hpp"

namespace record {
namespace {

constexpr const char* kRecording = ".axrec";
constexpr const char* kLog = ".log";
constexpr const char* kOlder = ".1";
/// Above the longest line of a log.
constexpr std::size_t kLineBytes = 128;

std::array<std::byte, kChecksumBytes> checksum_of(std::span<const std::byte> bytes) noexcept {
  const std::uint32_t crc = checksum::crc32(bytes);
  std::array<std::byte, kChecksumBytes> checksum{};
  for (std::size_t i = 0; i < checksum.size(); ++i) checksum[i] = static_cast<std::byte>(crc >> 8 * i);
  return checksum;
}

}  // namespace

/// Each share is that of a recording or of its log.
Segments::Segments(Plan plan)
    : plan_{std::move(plan)},
      share_{plan_.most_bytes / 2 / (plan_.by_faults ? kFaults : kHalves)},
      where_{plan_.folder.string()} {}

std::string Segments::path(const std::string& suffix, const char* extension) const {
  return (plan_.folder / (plan_.name + suffix + extension)).string();
}

/// The first that is free, or else the one that was written the longest time ago.
std::string Segments::fault_suffix() const {
  std::optional<std::filesystem::file_time_type> oldest;
  std::string found;
  for (unsigned number = 1; number <= kFaults; ++number) {
    std::string suffix = "-" + std::to_string(number);
    std::error_code missing;
    const auto written = std::filesystem::last_write_time(path(suffix, kRecording), missing);
    if (missing) return suffix;
    if (oldest && *oldest <= written) continue;
    oldest = written;
    found = suffix;
  }
  return found;
}

int Segments::open() noexcept {
  try {
    where_ = plan_.folder.string();
    if (::mkdir(where_.c_str(), S_IRWXU) != 0 && errno != EEXIST) return errno;
    if (plan_.by_faults) return open_files(fault_suffix());
    for (const char* const extension : {kRecording, kLog})
      if (::rename(path("", extension).c_str(), path(kOlder, extension).c_str()) != 0 && errno != ENOENT)
        return errno;
    return open_files("");
  } catch (const std::exception&) {
    return ENOMEM;
  }
}

int Segments::open_files(const std::string& suffix) noexcept {
  if (const int error = log_.open(path(suffix, kLog))) return error;
  where_ = path(suffix, kRecording);
  if (const int error = recording_.open(where_)) return error;
  return write_head();
}

int Segments::write_head() noexcept {
  const std::span text = std::as_bytes(std::span{plan_.head});
  std::array<std::byte, kHeadBytes> head{};
  std::ranges::transform(kMagic, head.begin(), [](char letter) { return static_cast<std::byte>(letter); });
  head[kMagic.size()] = static_cast<std::byte>(kVersion);
  for (std::size_t i = 0; i < sizeof(std::uint32_t); ++i)
    head[kHeadBytes - sizeof(std::uint32_t) + i] = static_cast<std::byte>(text.size() >> 8 * i);
  const auto checksum = checksum_of(text);
  for (const auto part : {std::span<const std::byte>{head}, text, std::span<const std::byte>{checksum}})
    if (const int error = recording_.write(part)) return error;
  return 0;
}

bool Segments::has_room(std::span<const std::byte> record) const noexcept {
  const std::size_t end = 2 * (kRecordHeadBytes + kChecksumBytes);  // of the record itself, and of the last one
  return recording_.size() + record.size() + end <= share_ && log_.size() + kLineBytes <= share_;
}

int Segments::write(std::span<const std::byte> record) noexcept {
  if (const int error = recording_.write(record)) return error;
  if (const int error = recording_.write(checksum_of(record))) return error;
  if (type_of(record) != RecordType::Frame) return 0;
  try {
    const auto content = content_of(record);
    if (!content) return 0;
    return log_.write(candump_line(std::get<FrameRecord>(*content).frame, plan_.wall_clock + moment_of(record),
                                   plan_.interface));
  } catch (const std::exception&) {
    return ENOMEM;
  }
}

int Segments::flush() noexcept {
  if (const int error = recording_.flush()) return error;
  return log_.flush();
}

int Segments::close(EndReason reason, Moment at) noexcept {
  int error = write(end_record(reason, at).bytes());
  if (error == 0) error = flush();
  abandon();
  return error;
}

void Segments::abandon() noexcept {
  recording_.close();
  log_.close();
}

}  // namespace record
