#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drive/axis/axis.hpp"

namespace drive {

/// What a transition of the sequence control needs.
struct ConditionView {
  std::string text;       ///< a sentence without its full stop: what has to be, and where it comes from
  bool met = false;       ///< now
  std::string parameter;  ///< "p0840"; empty where there is none
};

/// A transition of the sequence control as a person looks at it.
struct TransitionView {
  std::optional<int> number;  ///< that of CiA 402, which does not know all of them
  State from{};
  State to{};
  bool by_itself = false;  ///< the unit takes it without a command
  bool is_open = false;    ///< `from` is the present state, and every condition is met
  std::vector<ConditionView> conditions{};
};

/// All transitions from one state of @p axis to another, from the table of the sequence control, with what they
/// need as it is after the last cycle. For people: it allocates and looks parameters up, so it has no place in a
/// cycle.
std::vector<TransitionView> state_machine(const Axis& axis);

}  // namespace drive
