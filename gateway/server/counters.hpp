#pragma once

#include <cstdint>
#include <map>

namespace gateway {

/// What the server has done so far, and what it does.
struct Counters {
  std::map<unsigned, std::uint64_t> answers{};  ///< by status of HTTP
  std::uint64_t connections = 0;                ///< that are open
  std::uint64_t viewers = 0;                    ///< streams that are open
  std::uint64_t cut_off_viewers = 0;            ///< streams ended because they were not read
  std::uint64_t late_requests = 0;              ///< connections closed because no request came in time
};

}  // namespace gateway
