#pragma once

#include <cstdint>
#include <string>

#include "tools/canrec/frames/failure.hpp"

namespace canrec {

/// Which log is meant, and what of it.
struct LogChoice {
  std::string path;
  std::string interface;      ///< empty: the log has one only
  bool skip_damaged = false;  ///< go on without lines that are damaged
};

/// Reads all of the log before anything is done with it; damaged lines are told. Name of the interface whose
/// frames are meant. A failure if a line is damaged, unless these are left out, and if there is no frame.
[[nodiscard]] Expected<std::string> check_log(const LogChoice& choice);

}  // namespace canrec
