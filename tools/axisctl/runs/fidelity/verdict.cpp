#include "tools/axisctl/runs/fidelity/verdict.hpp"

namespace runs {

void Verdict::add_same(Aspect aspect) {
  ++fidelity_.of(aspect).compared;
  ++fidelity_.of(aspect).same;
}

void Verdict::add_within(Aspect aspect) {
  ++fidelity_.of(aspect).compared;
  ++fidelity_.of(aspect).within;
}

void Verdict::add(Finding finding) {
  finding.known = known_.reason_of(finding);
  Tally& tally = fidelity_.of(finding.aspect);
  ++tally.compared;
  ++(!finding.known.empty() ? tally.known : finding.nature == Nature::Missing ? tally.missing : tally.different);
  if (fidelity_.findings.size() < kMostFindings)
    fidelity_.findings.push_back(std::move(finding));
  else
    ++fidelity_.left_out;
}

}  // namespace runs
