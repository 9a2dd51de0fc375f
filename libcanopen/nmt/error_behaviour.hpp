#pragma once

#include <cstdint>

#include "libcanopen/base/nmt_state.hpp"
#include "libcanopen/od/dictionary.hpp"

namespace canopen {

/// Knows which NMT state an error leads to (CiA 301, 7.5.2.32; object 1029h).
class ErrorBehaviour final : public EntryOwner {
 public:
  /// Owns what can be written of 1029h in @p dictionary, which must outlive it. Works without the object.
  explicit ErrorBehaviour(Dictionary& dictionary);

  /// The state that an error of class @p error_class (sub-index of 1029h) leads to from @p state. A class that the
  /// dictionary does not have, or that holds a reserved value: Pre-operational if @p state is Operational.
  NmtState after(std::uint8_t error_class, NmtState state) const noexcept;

  /// InvalidValue for the reserved values.
  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  const Dictionary& dictionary_;
};

}  // namespace canopen
