#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/axisctl/scenario/run/observation.hpp"

namespace scenario {

/// The conditions that must never or always hold while steps go on.
class Watches {
 public:
  /// Begins to watch what @p step, whose action is never or always, says; frames from @p mark on.
  void add(const Step& step, std::size_t mark);
  /// The step called @p name begins: nothing that has it as its end is watched any more.
  void end_before(const std::string& name);
  /// Ends the watch of @p step.
  void end(const Step& step);
  /// The step that is violated now, with what there was.
  struct Violation {
    const Step* step = nullptr;
    std::string text{};
  };
  [[nodiscard]] std::optional<Violation> look(Context& context);

 private:
  struct Watch {
    const Step* step = nullptr;
    bool must_hold = false;
    Observation observation;
  };
  std::vector<Watch> watches_;
};

}  // namespace scenario
