// Why an axis does not turn, as far as positioning knows.
#include "drive/explain/explain_reasons.hpp"

namespace drive {

std::span<const explanation::Reason> Positioner::reasons() noexcept {
  return {};
}

std::span<const explanation::Reason> PositionControl::reasons() noexcept {
  return {};
}

}  // namespace drive
