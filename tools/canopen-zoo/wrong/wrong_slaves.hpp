#pragma once

#include <set>
#include <string>
#include <vector>

#include "tools/canopen-zoo/slave/slave.hpp"

namespace zoo {

/// A slave that is wrong on purpose.
struct WrongSlave {
  std::string name;  ///< letters and digits, unique
  std::string what;  ///< is wrong: a sentence
  Defect defect;
  std::set<std::string> found_by;  ///< ids of the checks of canopen-check that find it, and no others do
};

/// All of them, group by group.
[[nodiscard]] std::vector<WrongSlave> wrong_slaves();

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
[[nodiscard]] std::vector<WrongSlave> wrong_storage_slaves();
[[nodiscard]] std::vector<WrongSlave> wrong_drive_slaves();

/// A slave that does everything right, LSS too.
[[nodiscard]] Defect right_lss();

}  // namespace zoo
