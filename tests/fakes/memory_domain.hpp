#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "libcanopen/od/domain_owner.hpp"

namespace fakes {

/// A DOMAIN in memory that notes everything that is asked of it.
class MemoryDomain final : public canopen::DomainOwner {
 public:
  using Bytes = std::vector<std::uint8_t>;
  using AbortCode = canopen::AbortCode;

  canopen::Result<std::optional<std::uint32_t>> begin_read(const canopen::Entry&) noexcept override {
    if (refuse_begin) return canopen::refuse(*refuse_begin);
    ++reads;
    if (!says_size) return std::nullopt;
    return static_cast<std::uint32_t>(bytes.size());
  }
  canopen::Result<std::size_t> read(const canopen::Entry&, std::uint64_t offset,
                                    std::span<std::uint8_t> into) noexcept override {
    if (offset >= refuse_from) return canopen::refuse(AbortCode::HardwareError);
    asked.push_back({offset, into.size()});
    const std::size_t count = std::min<std::size_t>(into.size(), bytes.size() - std::min(offset, bytes.size()));
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(offset), count, into.begin());
    return count;
  }
  canopen::Result<void> begin_write(const canopen::Entry&, std::optional<std::uint32_t> size) noexcept override {
    if (refuse_begin) return canopen::refuse(*refuse_begin);
    announced = size;
    coming.clear();
    ++writes;
    return {};
  }
  canopen::Result<void> write(const canopen::Entry&, std::uint64_t offset,
                              std::span<const std::uint8_t> more) noexcept override {
    if (offset + more.size() > refuse_from) return canopen::refuse(AbortCode::OutOfMemory);
    asked.push_back({offset, more.size()});
    coming.insert(coming.end(), more.begin(), more.end());
    return {};
  }
  canopen::Result<void> end_write(const canopen::Entry&, std::uint64_t size) noexcept override {
    if (refuse_end) return canopen::refuse(*refuse_end);
    ended_with = size;
    bytes = coming;
    return {};
  }
  void cancel_write(const canopen::Entry&) noexcept override { ++cancelled; }

  /// True if every piece begins where the one before it ended; the first one at 0.
  bool was_asked_in_order() const {
    std::uint64_t next = 0;
    for (const Piece& piece : asked) {
      if (piece.offset != next) return false;
      next += piece.size;
    }
    return true;
  }

  struct Piece {
    std::uint64_t offset;
    std::size_t size;
  };
  Bytes bytes;               ///< what counts
  Bytes coming;              ///< what is being written
  bool says_size = true;     ///< when it is read
  std::vector<Piece> asked;  ///< of read() or write()
  std::optional<std::uint32_t> announced;
  std::optional<std::uint64_t> ended_with;
  int reads = 0, writes = 0, cancelled = 0;
  std::optional<AbortCode> refuse_begin, refuse_end;
  std::uint64_t refuse_from = UINT64_MAX;  ///< offset
};

}  // namespace fakes
