#include "farm/door/service/host_claim.hpp"

namespace farm {

void HostClaim::hear(std::uint64_t instance, Time now) noexcept {
  if (instance == instance_ || (has_ && instance > instance_)) return;
  other_ = now;
}

bool HostClaim::is_free(Time now) const noexcept {
  return !other_ || now - *other_ > kPatience;
}

}  // namespace farm
