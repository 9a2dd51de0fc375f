#pragma once

#include <map>
#include <set>
#include <utility>

#include "audit/base/topic.hpp"
#include "audit/network/pdo_record.hpp"

namespace audit {

/// How PDOs are configured: the order of the steps, and what they write.
class PdoSettingTopic final : public Topic {
 public:
  void on_frame(const Passage& passage, const Scene& scene) override;
  void on_transfer(const Transfer& transfer, const Scene& scene) override;

 private:
  void take_communication(const Transfer& transfer, const PdoRecord& record, const Scene& scene);
  void take_cob_id(const Transfer& transfer, const PdoRecord& record, const Scene& scene);
  void take_mapping(const Transfer& transfer, const PdoRecord& record, const Scene& scene);
  void note_refused(const Transfer& transfer, const PdoRecord& record, const Scene& scene);
  void take_count(const Transfer& transfer, const PdoRecord& record, const Scene& scene);

  using Place = std::pair<std::uint8_t, PdoRecord>;

  void start(std::uint8_t node, const Heard& heard, const Scene& scene);
  void forget(std::uint8_t node);

  /// PDOs that are being configured: the transfer that has mapped something since they were taken out of use.
  std::map<Place, Heard> in_work_;
  /// PDOs that were in use, or are mapped otherwise than before.
  std::set<Place> changed_;
  /// PDOs of whose mapping a step was refused since they were taken out of use: the abort.
  std::map<Place, Heard> refused_;
};

}  // namespace audit
