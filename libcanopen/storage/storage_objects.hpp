#pragma once

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"

namespace canopen {

/// Checks the signatures "save" in 1010h and "load" in 1011h before the application stores or restores parameters
/// (CiA 301, 7.5.2.13 and 7.5.2.14). Reading gives what the device can do: the initial value of the entry.
class CANOPEN_EXPORT StorageObjects final : public EntryOwner {
 public:
  explicit StorageObjects(Context& context);

  Result<std::int64_t> read(const Entry& entry, std::int64_t stored) override;
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  void own(std::uint16_t index);

  Context& context_;
};

}  // namespace canopen
