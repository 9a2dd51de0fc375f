#pragma once

#include <set>
#include <string>

#include "tests/tools/canopen-check/slave/slave.hpp"
#include "tools/canopen-check/core/run/runner.hpp"

namespace conformance_test {

/// What the user allows in runs of the tests: everything.
[[nodiscard]] conformance::Settings full_settings();

/// Runs every check that needs the node, or those whose id begins with @p only, against a slave with @p defect.
[[nodiscard]] conformance::RunReport run_checks(const Defect& defect, std::string_view only = {},
                                                const conformance::Settings& settings = full_settings());

/// The ids of checks that have a finding.
[[nodiscard]] std::set<std::string> failed_checks(const conformance::RunReport& report);

/// Every finding and every check that could not be ended, a line each, for messages of tests.
[[nodiscard]] std::string findings_of(const conformance::RunReport& report);

/// A slave that is wrong on purpose.
struct WrongSlave {
  std::string name;  ///< of the test
  Defect defect;
  std::set<std::string> found_by;  ///< ids of the checks that find it, and no others
};

// Those of each group: wrong_sdo_slaves.cpp and so on.
[[nodiscard]] std::vector<WrongSlave> wrong_device_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_nmt_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_error_control_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_sdo_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_sdo_block_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_sdo_server_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_pdo_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_pdo_parameter_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_pdo_mapping_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_pdo_transmission_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_pdo_reception_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_sync_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_emcy_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_robustness_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_lss_slaves();

/// A slave that does everything right, LSS too.
[[nodiscard]] Defect right_lss();
[[nodiscard]] std::vector<WrongSlave> wrong_storage_slaves();

}  // namespace conformance_test
