#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "record/format.hpp"

namespace record {

/// A frame that has come or was sent.
struct FrameRecord {
  canopen::Frame frame;
  bool sent;
};
/// Values of the signals that the head names.
struct SamplesRecord {
  std::vector<double> values;
};
/// So many records had no room here.
struct LostRecord {
  std::uint64_t records;
};
/// The file ends here.
struct EndRecord {
  EndReason reason;
};
/// A record of a type that this reader knows. The texts of an event lie in the content that is read.
struct Record {
  Moment at{};
  std::variant<FrameRecord, Event, SamplesRecord, LostRecord, EndRecord> content;
};

/// What @p record, without its checksum, holds; nothing if it is of an unknown type or too short for its own.
std::optional<decltype(Record::content)> content_of(std::span<const std::byte> record);

/// Reads a recording from its first record to the last whole one.
class Reader {
 public:
  /// How what is read ends.
  enum class Ending : std::uint8_t {
    NotYet,   ///< there is more
    Whole,    ///< with a record that says so
    Open,     ///< behind a whole record: whoever wrote it came to no end, or has not yet
    Cut,      ///< within a record
    Damaged,  ///< what follows is no record with its checksum
  };

  /// Opens @p content, which outlives this; or why it is no recording, or none that this can read.
  static tl::expected<Reader, std::string> open(std::span<const std::byte> content);

  /// What the head says: unit, wall clock, signals (docs/reference/recording.md).
  const nlohmann::json& head() const noexcept { return head_; }
  /// The next record of a known type; nothing at the end.
  std::optional<Record> next();
  Ending ending() const noexcept { return ending_; }
  /// Where the last whole record ends (bytes from the beginning).
  std::size_t position() const noexcept { return position_; }
  /// Bytes behind that.
  std::size_t left() const noexcept { return content_.size() - position_; }
  /// Records of unknown types so far.
  std::size_t skipped() const noexcept { return skipped_; }
  /// How it ends, in a sentence; empty if whole.
  std::string remark() const;

 private:
  Reader(std::span<const std::byte> content, std::size_t first, nlohmann::json head)
      : content_{content}, position_{first}, head_(std::move(head)) {}
  /// The bytes of the next record without its checksum; empty at the end.
  std::span<const std::byte> take() noexcept;

  std::span<const std::byte> content_;
  std::size_t position_;
  nlohmann::json head_;
  Ending ending_ = Ending::NotYet;
  std::size_t skipped_ = 0;
};

}  // namespace record
