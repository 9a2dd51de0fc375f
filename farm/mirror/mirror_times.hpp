#pragma once

#include <chrono>

namespace farm {

/// How long a mirror has patience.
struct MirrorTimes {
  std::chrono::milliseconds quiet{500};  ///< all doors have told who is there when none has been new for so long
  std::chrono::milliseconds longest{
      3000};  ///< or when so long has passed; the server has to answer in this time, too
  std::chrono::milliseconds silence{2000};  ///< of a door, after which its host counts as silent
  std::chrono::milliseconds answer{8000};   ///< for a unit; less than clients of a control socket have
  std::chrono::milliseconds keep{3000};     ///< from one sign of life to the unit to the next, while it delivers
};

}  // namespace farm
