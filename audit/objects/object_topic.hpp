#pragma once

#include "audit/base/topic.hpp"

namespace audit {

/// What a master reads and writes against what the device has: by the codes of aborts, and by the EDS.
class ObjectTopic final : public Topic {
 public:
  void on_transfer(const Transfer& transfer, const Scene& scene) override;
};

}  // namespace audit
