#include "libcanopen/nmt/error_behaviour.hpp"

#include "libcanopen/base/object_index.hpp"

namespace canopen {
namespace {

// Values of an error class (CiA 301, 7.5.2.32).
constexpr std::int64_t kLeaveOperational = 0;
constexpr std::int64_t kNoChange = 1;
constexpr std::int64_t kStop = 2;

}  // namespace

ErrorBehaviour::ErrorBehaviour(Dictionary& dictionary) : dictionary_{dictionary} {
  for (const Entry& entry : dictionary.entries()) {
    if (entry.index != object::kErrorBehaviour || entry.sub_index == 0) continue;
    dictionary.serve_writes(entry.index, entry.sub_index, *this);
  }
}

NmtState ErrorBehaviour::after(std::uint8_t error_class, NmtState state) const noexcept {
  const Entry* const entry = error_class != 0 ? dictionary_.lookup(object::kErrorBehaviour, error_class) : nullptr;
  const std::int64_t behaviour = entry != nullptr ? dictionary_.stored(*entry) : kLeaveOperational;
  if (behaviour == kNoChange) return state;
  if (behaviour == kStop) return NmtState::Stopped;
  return state == NmtState::Operational ? NmtState::PreOperational : state;
}

Result<void> ErrorBehaviour::write(const Entry&, std::int64_t value) {
  if (value != kLeaveOperational && value != kNoChange && value != kStop) return refuse(AbortCode::InvalidValue);
  return {};
}

}  // namespace canopen
