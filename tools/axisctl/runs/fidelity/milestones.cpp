#include "tools/axisctl/runs/fidelity/milestones.hpp"

#include <algorithm>

namespace runs {

void judge_order(std::vector<Milestone> milestones, const TimeMap& times, Verdict& verdict) {
  std::ranges::stable_sort(milestones, {}, &Milestone::place);
  for (std::size_t i = 1; i < milestones.size(); ++i) {
    const Milestone &first = milestones[i - 1], &second = milestones[i];
    if (second.run >= first.run) {
      verdict.add_same(Aspect::Order);
      continue;
    }
    const canopen::Duration by = (second.log - first.log) + (first.run - second.run);
    if (by <= times.band(second.log)) {
      verdict.add_within(Aspect::Order);
      continue;
    }
    verdict.add({.aspect = Aspect::Order,
                 .nature = Nature::Order,
                 .at = second.log,
                 .place = second.place,
                 .what = second.what,
                 .log = "behind " + first.what,
                 .run = "before it"});
  }
}

}  // namespace runs
