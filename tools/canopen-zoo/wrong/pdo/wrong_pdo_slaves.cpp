#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {

std::vector<WrongSlave> wrong_pdo_slaves() {
  std::vector<WrongSlave> slaves;
  for (const auto more : {wrong_pdo_parameter_slaves, wrong_pdo_mapping_slaves, wrong_pdo_transmission_slaves,
                          wrong_pdo_reception_slaves})
    for (WrongSlave& slave : more()) slaves.push_back(std::move(slave));
  return slaves;
}

}  // namespace zoo
