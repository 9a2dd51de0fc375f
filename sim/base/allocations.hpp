#pragma once

#include <cstdint>

namespace sim {

/// Allocations of the units of a world, which have to be none once they run. The program counts them: see
/// program/count_allocations.cpp; without that file nothing is ever counted.
struct Allocations {
  std::uint64_t count = 0;
  bool counts = false;
};
inline Allocations allocations;

/// While there is one, what is allocated is counted: a unit is at work.
class Counted {
 public:
  Counted() noexcept : before_{allocations.counts} { allocations.counts = true; }
  ~Counted() { allocations.counts = before_; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 private:
  bool before_;
};

/// While there is one, nothing is counted: the world around the unit is at work.
class Uncounted {
 public:
  Uncounted() noexcept : before_{allocations.counts} { allocations.counts = false; }
  ~Uncounted() { allocations.counts = before_; }
  Uncounted(const Uncounted&) = delete;
  Uncounted& operator=(const Uncounted&) = delete;

 private:
  bool before_;
};

}  // namespace sim
