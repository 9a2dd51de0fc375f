#pragma once

#include <optional>
#include <vector>

#include "libcanopen/service/service.hpp"
#include "libcanopen/sync/sync_listener.hpp"

namespace canopen {

/// Knows which identifier is SYNC and what a SYNC says (CiA 301, 7.2.5; objects 1005h, 1007h, 1019h). The node
/// does not produce SYNC: bit 30 of 1005h is refused.
class SyncConsumer final : public Service, public EntryOwner {
 public:
  explicit SyncConsumer(Context& context);

  /// @p listener, which must outlive this, is told of every SYNC, after those that were added before and before
  /// the application. To be called before the node starts.
  void tell(SyncListener& listener) { listeners_.push_back(&listener); }

  void list_identifiers(IdentifierList& list) const noexcept override;
  void reload(Reload how) noexcept override;
  /// A SYNC, unless it has the wrong length, which is reported once (CiA 301, 7.5.2.22) and counts only if the
  /// policy says so.
  void on_frame(const Frame& frame, std::size_t slot) noexcept override;

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Result<void> write_cob_id(std::uint32_t cob_id);
  Result<void> write_overflow(std::int64_t value);
  void set_overflow(std::int64_t value) noexcept;
  std::optional<std::int64_t> stored(std::uint16_t index) const noexcept;
  void on_wrong_length(std::uint8_t length) noexcept;
  void recover() noexcept;

  std::vector<SyncListener*> listeners_;
  Identifier identifier_ = 0;  ///< in use, 0 if the node has no object 1005h
  Duration window_{};          ///< after a SYNC, in which synchronous RPDOs are taken (1007h), 0 for any time
  std::uint8_t shortest_ = 0;  ///< of the frames that are a SYNC, in bytes
  std::uint8_t longest_ = 1;
  std::optional<std::uint8_t> wrong_length_{};  ///< as reported
};

}  // namespace canopen
