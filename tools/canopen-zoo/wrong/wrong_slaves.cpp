#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

#include <utility>

namespace zoo {

std::vector<WrongSlave> wrong_slaves() {
  std::vector<WrongSlave> all;
  for (const auto slaves :
       {wrong_device_slaves, wrong_nmt_slaves, wrong_error_control_slaves, wrong_sdo_slaves,
        wrong_sdo_block_slaves, wrong_sdo_server_slaves, wrong_pdo_slaves, wrong_sync_slaves, wrong_emcy_slaves,
        wrong_robustness_slaves, wrong_lss_slaves, wrong_storage_slaves, wrong_drive_slaves})
    for (WrongSlave& slave : slaves()) all.push_back(std::move(slave));
  return all;
}

}  // namespace zoo
