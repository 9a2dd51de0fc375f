#include "audit/pdo/pdo_frame_topic.hpp"

#include <fmt/format.h>

#include "audit/pdo/pdo_rules.hpp"

namespace audit {

namespace rules = pdo_rules;

using canopen::NmtState;
using meaning::Role;

namespace {

/// Time that a master has to notice what has become of a node.
constexpr canopen::Duration kTimeToNotice = std::chrono::milliseconds{100};

/// Whether at @p at the node has just booted, or was just told to change its state.
bool is_news(const Node& node, canopen::Duration at) noexcept {
  const bool has_just_booted = node.boot_up && at - node.boot_up->at < kTimeToNotice;
  return has_just_booted || (node.told && at - node.told->at < kTimeToNotice);
}

}  // namespace

void PdoFrameTopic::on_frame(const Passage& passage, const Scene& scene) {
  if (passage.heard.is_error) return;
  if (passage.meaning.role == Role::Rpdo && !passage.frame().remote) take_rpdo(passage, scene);
  if (passage.meaning.role == Role::Tpdo && passage.frame().remote) take_request(passage, scene);
}

void PdoFrameTopic::take_rpdo(const Passage& passage, const Scene& scene) {
  const Node& node = scene.network.node(passage.meaning.node);
  const bool is_asleep = node.is_there && node.state && *node.state != NmtState::Operational;
  if (is_asleep && (passage.is_shared || is_news(node, passage.at()))) return;
  if (is_asleep) {
    const Heard& sign = node.error_control ? *node.error_control : node.told.value_or(passage.heard);
    return scene.findings.add(rules::kBeforeOperational, node.id, {sign, passage.heard}, [&] {
      return fmt::format("RPDO {}: the node is {}", passage.meaning.number, canopen::name_of(*node.state));
    });
  }
  const Known& pdo = known(node, passage.meaning.number);
  const unsigned length = passage.frame().length;
  if (!pdo.is_known || length == pdo.bytes) return;
  scene.findings.add(length < pdo.bytes ? rules::kShort : rules::kLong, node.id, {passage.heard}, [&] {
    return fmt::format("RPDO {}: {} bytes, {} are mapped", passage.meaning.number, length, pdo.bytes);
  });
}

void PdoFrameTopic::take_request(const Passage& passage, const Scene& scene) {
  const Node& node = scene.network.node(passage.meaning.node);
  const PdoRecord record{.is_receive = false, .number = passage.meaning.number};
  const auto cob_id = node.value(record.communication(), kCobIdSub);
  if (cob_id && (*cob_id & canopen::cob_id::kNoRemote) != 0)
    scene.findings.add(rules::kRemote, node.id, {passage.heard}, [&] { return name_of(record); });
}

const PdoFrameTopic::Known& PdoFrameTopic::known(const Node& node, std::uint16_t number) {
  Known& pdo = rpdos_[{node.id, number}];
  if (pdo.changes == node.changes + 1) return pdo;
  pdo = {.changes = node.changes + 1};
  const auto objects = mapping_of(node, {.is_receive = true, .number = number});
  if (!objects) return pdo;
  pdo.is_known = true;
  pdo.bytes = bytes_of(*objects);
  return pdo;
}

}  // namespace audit
