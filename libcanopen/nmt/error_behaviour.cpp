#include "libcanopen/nmt/error_behaviour.hpp"

namespace canopen {
namespace {

constexpr std::uint16_t kErrorBehaviour = 0x1029;
constexpr std::int64_t kNoChange = 1;
constexpr std::int64_t kStopped = 2;

}  // namespace

NmtState state_after_error(const Dictionary& dictionary, std::uint8_t error_class, NmtState state) noexcept {
  const Entry* const entry = dictionary.lookup(kErrorBehaviour, error_class);
  const std::int64_t behaviour = entry != nullptr ? dictionary.stored(*entry) : 0;
  if (behaviour == kNoChange) return state;
  if (behaviour == kStopped) return NmtState::Stopped;
  return state == NmtState::Operational ? NmtState::PreOperational : state;
}

}  // namespace canopen
