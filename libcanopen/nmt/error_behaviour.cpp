#include "libcanopen/nmt/error_behaviour.hpp"

namespace canopen {

NmtState state_after_error(const Dictionary&, std::uint8_t, NmtState state) noexcept {
  return state == NmtState::Operational ? NmtState::PreOperational : state;
}

}  // namespace canopen
