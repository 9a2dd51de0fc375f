#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drive/parameter/error.hpp"
#include "profidrive/parameter/big_endian.hpp"
#include "profidrive/parameter/format.hpp"
#include "profidrive/record/record.hpp"
#include "profidrive/record/request.hpp"

namespace profidrive::record {

/// Why a parameter is refused.
struct Error {
  drive::RefusalReason reason;
  std::uint16_t sub_index = 0;  ///< the first one that is missing or refused
};

/// Whether an error with @p reason names the sub-index.
constexpr bool has_sub_index(drive::RefusalReason reason) noexcept {
  using enum drive::RefusalReason;
  constexpr std::array kWith{ReadOnly, OutOfRange, NoIndex, OnlyZero, DescriptionFixed, IllegalValue};
  return std::ranges::find(kWith, reason) != kWith.end();
}

/// An answer while it is written. Every entry leaves room for an error behind it for each parameter that is still
/// to come.
class Answer {
 public:
  /// Format and number, or the shortest error, and of an error the code.
  static constexpr std::size_t kHead = 2, kError = 4;

  /// To a request with @p header about @p count parameters, into @p bytes.
  Answer(std::span<std::uint8_t, kMostBytes> bytes, const Header& header, std::size_t count) noexcept
      : bytes_{bytes}, to_come_{count} {
    bytes_[0] = header.reference;
    bytes_[1] = header.service;
    bytes_[2] = header.object;
    bytes_[3] = static_cast<std::uint8_t>(count);
  }

  /// Room for @p count values of @p format, for the next parameter; empty if it takes too much, which is told in
  /// their place.
  std::span<std::uint8_t> add_values(Format format, std::size_t count, std::size_t size) noexcept {
    const std::size_t bytes = count * size;
    const std::size_t padded = bytes + bytes % 2;
    if (!fits(kHead + padded)) {
      add_error({drive::RefusalReason::AnswerTooLong});
      return {};
    }
    add_head(format, count);
    std::ranges::fill(bytes_.subspan(size_, padded), std::uint8_t{0});
    const std::span<std::uint8_t> values = bytes_.subspan(size_, bytes);
    size_ += padded;
    return values;
  }
  /// The next parameter was written.
  void add_done() noexcept { add_head(Format::Zero, 0); }
  /// The next parameter was refused.
  void add_error(const Error& error) noexcept {
    bytes_[1] |= kNegative;
    const bool wants_place = has_sub_index(error.reason);
    const bool with_place = wants_place && fits(kError + sizeof error.sub_index);
    const auto reason = with_place == wants_place ? error.reason : drive::RefusalReason::AnswerTooLong;
    add_head(Format::Error, with_place ? 2 : 1);
    add_word(static_cast<std::uint16_t>(reason));
    if (with_place) add_word(error.sub_index);
  }

  bool is_negative() const noexcept { return (bytes_[1] & kNegative) != 0; }
  std::size_t size() const noexcept { return size_; }

 private:
  static constexpr std::uint8_t kNegative = 0x80;

  bool fits(std::size_t entry) const noexcept { return size_ + entry + kError * (to_come_ - 1) <= bytes_.size(); }
  void add_head(Format format, std::size_t count) noexcept {
    --to_come_;
    bytes_[size_++] = static_cast<std::uint8_t>(format);
    bytes_[size_++] = static_cast<std::uint8_t>(count);
  }
  void add_word(std::uint16_t word) noexcept {
    put_number(bytes_.subspan(size_, sizeof word), word);
    size_ += sizeof word;
  }

  std::span<std::uint8_t> bytes_;
  std::size_t size_ = kHeaderBytes;
  std::size_t to_come_;  ///< parameters
};

}  // namespace profidrive::record
