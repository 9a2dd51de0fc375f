#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "libcanopen/sdo/viewed_object.hpp"
#include "libcanopen/service/context.hpp"

namespace canopen::sdo {

/// Where the bytes of a download go. A number or a string is gathered and written when it is complete; to a
/// DomainOwner they are given on whenever the window is full, each byte once and in order.
class DownloadSink {
 public:
  /// Gathers the bytes in @p window, which holds the longest value.
  explicit DownloadSink(std::span<std::uint8_t> window) noexcept : window_{window} {}

  /// Begins a value of @p entry with @p size bytes if that is said. LengthMismatch if that is none of the entry's
  /// lengths; the refusal of the DomainOwner.
  Result<void> open(const Entry& entry, std::optional<std::uint32_t> size) noexcept;
  /// Begins a value of @p object likewise. LengthMismatch for a size that is not 1..8.
  Result<void> open(ViewedObject object, std::optional<std::uint32_t> size) noexcept;
  /// Takes @p bytes. LengthTooHigh for more than was said, LengthMismatch for more than the entry can hold; the
  /// refusal of the DomainOwner.
  Result<void> append(std::span<const std::uint8_t> bytes) noexcept;
  /// Writes the value: all of it has come. LengthTooLow for fewer bytes than was said; the refusal of the
  /// dictionary, of the DomainOwner or of the view, for which LengthMismatch if nothing has come.
  Result<void> commit(Context& context) noexcept;
  /// Gives the value up if it has not been written; nothing happens if nothing was begun.
  void cancel() noexcept;

 private:
  bool is_open() const noexcept { return entry_ != nullptr || object_; }
  void expect(std::uint64_t capacity, std::optional<std::uint32_t> size) noexcept;
  Result<void> flush() noexcept;
  Result<void> commit_viewed(SdoView& view) noexcept;

  std::span<std::uint8_t> window_;
  std::size_t held_ = 0;     ///< bytes in the window
  std::uint64_t given_ = 0;  ///< bytes that the owner has taken
  std::uint64_t most_ = 0;   ///< bytes that may come in all
  const Entry* entry_ = nullptr;
  bool size_said_ = false;                ///< `most_` must come
  std::optional<ViewedObject> object_{};  ///< if there is no entry
};

/// True for a number that every client may set to every value of its size: nobody has to be asked.
constexpr bool is_plain(const Entry& entry) noexcept {
  return entry.size != 0 && !entry.limited && entry.write_owner == nullptr;
}

/// Writes @p bytes to a number or a string and tells the application of it, or that the owner of a number has
/// refused. LengthMismatch, and what the dictionary refuses.
Result<void> write_value(Context& context, const Entry& entry, std::span<const std::uint8_t> bytes) noexcept;

}  // namespace canopen::sdo
