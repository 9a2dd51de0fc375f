#pragma once

#include <ostream>
#include <set>
#include <string>

#include "tests/tools/canopen-check/slave/simulated_wire.hpp"
#include "tests/tools/canopen-check/slave/slow_station.hpp"
#include "tools/canopen-check/core/run/runner.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {

/// For the messages of tests.
void PrintTo(const WrongSlave& slave, std::ostream* out);

}  // namespace zoo

namespace conformance_test {

using namespace zoo;

// Identifiers of the slave, which has node-ID 5.
inline constexpr std::uint32_t kEmcyOf5 = 0x085, kResponseOf5 = 0x585, kRequestOf5 = 0x605,
                               kErrorControlOf5 = 0x705;

/// What the user allows in runs of the tests: everything.
[[nodiscard]] conformance::Settings full_settings();

/// Runs every check that needs the node, or those whose id begins with @p only, against a slave with @p defect.
[[nodiscard]] conformance::RunReport run_checks(const Defect& defect, std::string_view only = {},
                                                const conformance::Settings& settings = full_settings());

/// The same against a slave that is slow.
[[nodiscard]] conformance::RunReport run_checks(const Defect& defect, const Slowness& slowness,
                                                std::string_view only = {});

/// What the EDS of a slave that is right says.
[[nodiscard]] eds::Description right_description();

/// The ids of checks that have a finding.
[[nodiscard]] std::set<std::string> failed_checks(const conformance::RunReport& report);

/// Every finding and every check that could not be ended, a line each, for messages of tests.
[[nodiscard]] std::string findings_of(const conformance::RunReport& report);

}  // namespace conformance_test
