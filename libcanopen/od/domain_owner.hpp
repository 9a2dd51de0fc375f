#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "libcanopen/base/export.hpp"
#include "libcanopen/od/abort_code.hpp"

namespace canopen {

struct Entry;

/// What stands behind a DOMAIN: data of any length that is passed on piece by piece and never held as a whole.
/// Every byte of a transfer is asked for, or given, once and in order. Several clients may read at the same time,
/// each with its own offset; who writes is alone: all others, and a write while somebody reads, are refused with
/// DeviceState. A refusal ends the transfer with its code. Every begin_write() that succeeds is followed by one
/// end_write() that succeeds or by one cancel_write(), unless the node is destroyed before. The end of a read is
/// not told. end_write() may reset the node (Node::command); a reset in write() ends the transfer with
/// DeviceState.
class CANOPEN_EXPORT DomainOwner {
 public:
  virtual ~DomainOwner() = default;
  /// A client begins to read. @p entry tells apart the DOMAINs of an owner of several. Returns the size in bytes,
  /// std::nullopt if only the end will tell.
  virtual Result<std::optional<std::uint32_t>> begin_read(const Entry& entry) noexcept {
    (void)entry;
    return refuse(AbortCode::UnsupportedAccess);
  }
  /// Fills @p into with the bytes from @p offset on and returns how many. Without a size, fewer than there is room
  /// for are the end; with one, no byte beyond it is asked for, and fewer end the transfer with CannotTransfer.
  virtual Result<std::size_t> read(const Entry& entry, std::uint64_t offset,
                                   std::span<std::uint8_t> into) noexcept {
    (void)entry, (void)offset, (void)into;
    return refuse(AbortCode::UnsupportedAccess);
  }
  /// A client begins to write @p size bytes; std::nullopt if it has not said how many. Fewer or more bytes than it
  /// has said never count.
  virtual Result<void> begin_write(const Entry& entry, std::optional<std::uint32_t> size) noexcept {
    (void)entry, (void)size;
    return refuse(AbortCode::UnsupportedAccess);
  }
  /// Takes @p bytes, the next ones from @p offset on.
  virtual Result<void> write(const Entry& entry, std::uint64_t offset,
                             std::span<const std::uint8_t> bytes) noexcept {
    (void)entry, (void)offset, (void)bytes;
    return refuse(AbortCode::UnsupportedAccess);
  }
  /// All @p size bytes are there (and their CRC is right, if there is one): they count from now on.
  virtual Result<void> end_write(const Entry& entry, std::uint64_t size) noexcept {
    (void)entry, (void)size;
    return {};
  }
  /// The transfer ends without success, be it a refusal of write() or end_write(): what was taken does not count.
  virtual void cancel_write(const Entry& entry) noexcept { (void)entry; }
};

}  // namespace canopen
