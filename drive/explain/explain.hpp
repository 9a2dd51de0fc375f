#pragma once

#include <string>
#include <vector>

#include "drive/axis/axis.hpp"
#include "drive/infeed/infeed.hpp"

namespace drive {

/// Why @p axis does not turn, the most important reason first, each a sentence with what to do about it; or that
/// it turns. For people: it allocates and looks parameters up, so it has no place in a cycle. What the bus has to
/// do with it is not known here; the sentences @p bus say it, and stand behind the faults that stop the axis.
std::vector<std::string> explain(const Axis& axis, const std::vector<std::string>& bus = {});

/// Why @p infeed does not operate, in the same way; nothing if it does.
std::vector<std::string> explain(const Infeed& infeed);

/// Whether @p axis turns with its pulses on as it is asked to, so that nothing has to be explained.
bool turns(const Axis& axis) noexcept;

}  // namespace drive
