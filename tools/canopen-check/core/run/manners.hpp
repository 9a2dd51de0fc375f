#pragma once

#include <string>

namespace conformance {

class Context;

/// What a run has found out about the node, so that no later check waits for it once more.
struct Manners {
  bool boots_without_message = false;  ///< it came back from a reset without a boot-up message
  bool sends_no_emergency = false;     ///< none for any error that the tester can bring about
  bool operational_asked = false;      ///< it is known whether it enters Operational
  std::string refuses_operational{};   ///< why it cannot be tested in Operational; empty if it enters it
};

/// Why the node does not enter Operational, with the error that it tells; empty if it does, or if it tells no
/// state. The node may be in any state afterwards.
[[nodiscard]] std::string refusal_of_operational(Context& context);

}  // namespace conformance
