#pragma once

#include <optional>

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Knows which identifier is SYNC and what a SYNC says (CiA 301, 7.2.5; objects 1005h, 1007h, 1019h). The node
/// does not produce SYNC: bit 30 of 1005h is refused.
class CANOPEN_EXPORT SyncConsumer final : public EntryOwner {
 public:
  explicit SyncConsumer(Context& context);

  /// Starts over with the values of the objects.
  void reload() noexcept;
  /// The identifier in use; 0 if the node has no object 1005h.
  Identifier identifier() const noexcept { return identifier_; }
  /// How long after a SYNC synchronous RPDOs are taken (1007h); 0 for any time.
  Duration window() const noexcept { return window_; }
  /// The counter of a SYNC, 0 if it carries none; std::nullopt if @p frame has the wrong length, which is reported
  /// once (CiA 301, 7.5.2.22).
  std::optional<std::uint8_t> on_frame(const Frame& frame) noexcept {
    if (frame.length < shortest_ || frame.length > longest_) return on_wrong_length(frame.length);
    if (wrong_length_) recover();
    return frame.length == 1 ? frame.data[0] : std::uint8_t{0};
  }

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Result<void> write_cob_id(std::uint32_t cob_id);
  Result<void> write_overflow(std::int64_t value);
  void set_overflow(std::int64_t value) noexcept;
  std::optional<std::int64_t> stored(std::uint16_t index) const noexcept;
  std::optional<std::uint8_t> on_wrong_length(std::uint8_t length) noexcept;
  void recover() noexcept;

  Context& context_;
  Identifier identifier_ = 0;
  Duration window_{};
  std::uint8_t shortest_ = 0;  ///< of the frames that are a SYNC, in bytes
  std::uint8_t longest_ = 1;
  std::optional<std::uint8_t> wrong_length_{};  ///< as reported
};

}  // namespace canopen
