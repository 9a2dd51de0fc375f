#include <array>

#include "tools/canopen-check/checks/check_table.hpp"
#include "tools/canopen-check/core/context.hpp"

namespace conformance {
namespace {

void boots_after_reset_node(Context& context) {
  if (const auto time = context.reset(canopen::NmtCommand::ResetNode))
    context.note("boot-up after " + milliseconds(*time));
}

constexpr std::array kChecks{
    Check{.id = "nmt.boot-up-after-reset-node",
          .name = "A reset of the node ends with the boot-up message",
          .clause = "CiA 301 7.3.2.2",
          .group = Group::Nmt,
          .run = boots_after_reset_node},
};

}  // namespace

std::span<const Check> nmt_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
