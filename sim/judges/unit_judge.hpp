#pragma once

#include <vector>

#include "sim/unit/judge.hpp"
#include "sim/unit/simulated_unit.hpp"

namespace sim {

/// A judge that keeps a @p Seen of each unit, which begins anew with the power.
template <class Seen>
class UnitJudge : public Judge {
 public:
  UnitJudge(std::string_view rule, std::size_t units) : Judge{rule}, seen_(units) {}

  void on_power(const SimulatedUnit& unit, bool) override { seen_[unit.number()] = {}; }

 protected:
  Seen& seen(const SimulatedUnit& unit) noexcept { return seen_[unit.number()]; }

 private:
  std::vector<Seen> seen_;
};

}  // namespace sim
