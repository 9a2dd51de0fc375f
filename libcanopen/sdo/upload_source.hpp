#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "libcanopen/base/export.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "libcanopen/sdo/viewed_object.hpp"

namespace canopen::sdo {

/// The bytes that an upload sends. A number or a string is taken as a whole when the upload begins; the data of a
/// DomainOwner come through the window, each byte asked for once and in order. What has been sent stays in the
/// window until it is dropped, so that it can be sent again.
class CANOPEN_EXPORT UploadSource {
 public:
  /// Keeps the bytes in @p window; eight more bytes behind it must be readable.
  explicit UploadSource(std::span<std::uint8_t> window) noexcept : window_{window} {}

  /// Begins with the value of @p entry. The refusal of its owner; OutOfMemory if a text is longer than the window.
  Result<void> open(const Dictionary& dictionary, const Entry& entry) noexcept;
  /// Begins with the value of @p object. The refusal of @p view; CannotTransfer if that gives no 1..8 bytes.
  Result<void> open(SdoView& view, ViewedObject object) noexcept;
  /// Bytes in all; std::nullopt if only the end will tell.
  std::optional<std::uint32_t> size() const noexcept { return size_; }

  /// Sees to it that @p bytes are there; fewer are there if and only if the data end with them. The refusal of the
  /// DomainOwner; CannotTransfer if it gives other amounts than it has promised.
  Result<void> want(std::size_t bytes) noexcept {
    if (available() >= bytes || ended_) return {};
    return refill();
  }
  /// Bytes that are there and not dropped.
  std::size_t available() const noexcept { return last_ - first_; }
  /// The first of them.
  const std::uint8_t* data() const noexcept { return window_.data() + first_; }
  /// Forgets the first @p bytes of them.
  void drop(std::size_t bytes) noexcept { first_ += bytes; }

 private:
  Result<void> open_domain(const Entry& entry) noexcept;
  Result<void> refill() noexcept;
  void hold(std::size_t bytes) noexcept;

  std::span<std::uint8_t> window_;
  std::size_t first_ = 0;  ///< the bytes that are there: first_ .. last_ - 1
  std::size_t last_ = 0;
  bool ended_ = true;             ///< nothing comes behind last_
  const Entry* entry_ = nullptr;  ///< whose owner is asked
  std::uint64_t asked_ = 0;       ///< bytes that the owner has given
  std::optional<std::uint32_t> size_{};
};

}  // namespace canopen::sdo
