#pragma once

#include <map>

#include "audit/base/topic.hpp"
#include "audit/network/pdo_record.hpp"

namespace audit {

/// The frames of PDOs that a master sends or asks for.
class PdoFrameTopic final : public Topic {
 public:
  void on_frame(const Passage& passage, const Scene& scene) override;

 private:
  /// What a PDO has mapped, as long as nothing has changed.
  struct Known {
    std::uint32_t changes = 0;
    bool is_known = false;
    unsigned bytes = 0;
  };

  void take_rpdo(const Passage& passage, const Scene& scene);
  static void take_request(const Passage& passage, const Scene& scene);
  const Known& known(const Node& node, std::uint16_t number);

  std::map<std::pair<std::uint8_t, std::uint16_t>, Known> rpdos_;
};

}  // namespace audit
