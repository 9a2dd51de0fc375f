#include "tools/canopen-check/checks/check_table.hpp"
#include "tools/canopen-check/core/context.hpp"

namespace conformance {

std::span<const Check> robustness_checks() noexcept {
  return {};
}

}  // namespace conformance
