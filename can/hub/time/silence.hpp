#pragma once

#include <string>

#include <sys/types.h>

namespace hub {

/// What /proc tells of @p process that acts and says nothing: "PROGRAM (process N), which is stopped";
/// std::bad_alloc.
[[nodiscard]] std::string describe_silent(pid_t process);

}  // namespace hub
