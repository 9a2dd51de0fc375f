#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "record/byte_ring.hpp"
#include "record/format.hpp"

namespace record {

/// The records of the last while, in memory that is there from the beginning: the oldest make room.
class History {
 public:
  /// Room for @p bytes, of which what is older than @p length leaves.
  History(std::size_t bytes, Moment length) : ring_{bytes}, length_{length} {}

  /// Takes @p record of @p at, which is not before those that are there.
  void push(std::span<const std::byte> record, Moment at) noexcept {
    while (begin_ != end_ && (ring_.size() - used() < record.size() || oldest() < at - length_)) drop();
    if (record.size() <= ring_.size()) end_ = ring_.put(end_, record);
  }
  void clear() noexcept { begin_ = end_; }
  /// Calls @p visit with every record, the oldest first.
  template <class Visit>
  void for_each(RecordBuffer& buffer, const Visit& visit) const {
    for (std::uint64_t at = begin_; at != end_;) {
      const auto record = record_at(ring_, at, buffer);
      at += record.size();
      visit(record);
    }
  }

 private:
  std::size_t used() const noexcept { return static_cast<std::size_t>(end_ - begin_); }
  std::array<std::byte, kRecordHeadBytes> head() const noexcept {
    std::array<std::byte, kRecordHeadBytes> head{};
    ring_.get(begin_, head);
    return head;
  }
  Moment oldest() const noexcept { return moment_of(head()); }
  void drop() noexcept { begin_ += size_of(head()); }

  ByteRing ring_;
  Moment length_;
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
};

}  // namespace record
