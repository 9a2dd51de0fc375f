#pragma once

#include <array>

#include "libcanopen/od/domain_owner.hpp"
#include "tests/fuzz/check.hpp"
#include "tests/fuzz/table.hpp"

namespace fuzz {

/// How a Domain behaves next.
struct DomainMode {
  std::uint16_t size = 20;           ///< bytes that a reader finds
  std::uint16_t most = 2000;         ///< bytes that a writer may announce
  std::uint16_t refuse_at = 0xFFFF;  ///< offset from which on reads and writes are refused
  bool unknown_size = false;         ///< the size is not told
  bool refuse_begin = false, refuse_end = false;
};

/// Data behind a DOMAIN that holds the library to its word: every byte once and in order, one writer alone, an end
/// or a cancellation for every beginning.
class Domain final : public canopen::DomainOwner {
 public:
  /// The server whose request is being handled; kServers: none.
  std::size_t server = kServers;
  DomainMode mode;

  void reset(const DomainMode& next) noexcept {
    *this = Domain{};
    mode = next;
  }
  bool is_being_written() const noexcept { return writing_; }

  canopen::Result<std::optional<std::uint32_t>> begin_read(const canopen::Entry&) noexcept override {
    require(!writing_, "no reader begins while one writes");
    require(server < kServers, "a transfer begins with a request");
    if (mode.refuse_begin) return canopen::refuse(canopen::AbortCode::ResourceNotAvailable);
    next_read_[server] = 0;
    if (mode.unknown_size) return std::nullopt;
    return mode.size;
  }
  canopen::Result<std::size_t> read(const canopen::Entry&, std::uint64_t offset,
                                    std::span<std::uint8_t> into) noexcept override {
    require(!writing_, "nothing is read while one writes");
    require(server < kServers, "data is read for a request");
    require(offset == next_read_[server], "bytes are asked for once and in order");
    if (offset + into.size() > mode.refuse_at) return canopen::refuse(canopen::AbortCode::HardwareError);
    const std::size_t left = offset < mode.size ? mode.size - offset : 0;
    const std::size_t count = std::min(left, into.size());
    for (std::size_t i = 0; i < count; ++i) into[i] = static_cast<std::uint8_t>(offset + i);
    next_read_[server] += count;
    return count;
  }
  canopen::Result<void> begin_write(const canopen::Entry&, std::optional<std::uint32_t> size) noexcept override {
    require(!writing_, "one client writes at a time");
    if (mode.refuse_begin) return canopen::refuse(canopen::AbortCode::LocalControl);
    if (size && *size > mode.most) return canopen::refuse(canopen::AbortCode::OutOfMemory);
    writing_ = true;
    writer_ = server;
    announced_ = size;
    written_ = 0;
    return {};
  }
  canopen::Result<void> write(const canopen::Entry&, std::uint64_t offset,
                              std::span<const std::uint8_t> bytes) noexcept override {
    require(writing_ && server == writer_, "only the client that has begun writes");
    require(offset == written_, "bytes are given once and in order");
    if (offset + bytes.size() > mode.refuse_at) return canopen::refuse(canopen::AbortCode::OutOfMemory);
    written_ += bytes.size();
    require(!announced_ || written_ <= *announced_, "no more bytes are given than were announced");
    return {};
  }
  canopen::Result<void> end_write(const canopen::Entry&, std::uint64_t size) noexcept override {
    require(writing_ && server == writer_, "only the client that has begun ends");
    require(size == written_, "the end tells the bytes that were given");
    require(!announced_ || size == *announced_, "as many bytes are given as were announced");
    if (mode.refuse_end) return canopen::refuse(canopen::AbortCode::GeneralError);
    writing_ = false;
    return {};
  }
  void cancel_write(const canopen::Entry&) noexcept override {
    require(writing_, "only what has begun is cancelled");
    writing_ = false;
  }

 private:
  bool writing_ = false;
  std::size_t writer_ = kServers;
  std::optional<std::uint32_t> announced_;
  std::uint64_t written_ = 0;
  std::array<std::uint64_t, kServers> next_read_{};
};

}  // namespace fuzz
