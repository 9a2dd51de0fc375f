#pragma once

#include "libcanopen/service/context.hpp"

namespace canopen {

/// What 1010h is written to store, "save", and 1011h to restore, "load": the first letter is in the lowest byte.
inline constexpr std::uint32_t kSaveSignature = 0x65766173;
inline constexpr std::uint32_t kLoadSignature = 0x64616F6C;

/// Checks the signatures "save" in 1010h and "load" in 1011h before the application stores or restores parameters
/// (CiA 301, 7.5.2.13 and 7.5.2.14). Reads keep giving the capabilities that the dictionary holds.
class StorageObjects final : public EntryOwner {
 public:
  explicit StorageObjects(Context& context);

  /// CannotTransfer without the signature; else the answer of the application.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Context& context_;
};

}  // namespace canopen
