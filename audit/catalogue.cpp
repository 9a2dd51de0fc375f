#include "audit/catalogue.hpp"

#include <algorithm>
#include <array>

#include "audit/auditor.hpp"
#include "audit/bus/bus_rules.hpp"
#include "audit/bus/bus_topic.hpp"
#include "audit/drive/drive_rules.hpp"
#include "audit/drive/drive_topic.hpp"
#include "audit/emcy/emcy_rules.hpp"
#include "audit/emcy/emcy_topic.hpp"
#include "audit/error_control/error_control_rules.hpp"
#include "audit/error_control/error_control_topic.hpp"
#include "audit/lss/lss_rules.hpp"
#include "audit/lss/lss_topic.hpp"
#include "audit/nmt/nmt_rules.hpp"
#include "audit/nmt/nmt_topic.hpp"
#include "audit/objects/object_rules.hpp"
#include "audit/objects/object_topic.hpp"
#include "audit/pdo/pdo_frame_topic.hpp"
#include "audit/pdo/pdo_rules.hpp"
#include "audit/pdo/pdo_setting_topic.hpp"
#include "audit/sdo/sdo_rules.hpp"
#include "audit/storage/storage_rules.hpp"
#include "audit/storage/storage_topic.hpp"
#include "audit/sync/sync_rules.hpp"
#include "audit/sync/sync_topic.hpp"

namespace audit {

namespace {

constexpr std::array kGroups{
    RuleGroup{"sdo", "SDO", sdo_rules::kAll},
    RuleGroup{"object", "Objects", object_rules::kAll},
    RuleGroup{"pdo", "PDO", pdo_rules::kAll},
    RuleGroup{"nmt", "NMT", nmt_rules::kAll},
    RuleGroup{"sync", "SYNC", sync_rules::kAll},
    RuleGroup{"error-control", "Error control", error_control_rules::kAll},
    RuleGroup{"emcy", "EMCY", emcy_rules::kAll},
    RuleGroup{"drive", "CiA 402", drive_rules::kAll},
    RuleGroup{"storage", "Store and restore", storage_rules::kAll},
    RuleGroup{"lss", "LSS", lss_rules::kAll},
    RuleGroup{"bus", "Bus", bus_rules::kAll},
};

}  // namespace

std::span<const RuleGroup> rule_groups() noexcept {
  return kGroups;
}

const Rule* find_rule(std::string_view id) noexcept {
  for (const RuleGroup& group : kGroups) {
    const auto rule = std::ranges::find(group.rules, id, &Rule::id);
    if (rule != group.rules.end()) return *rule;
  }
  return nullptr;
}

std::vector<std::unique_ptr<Topic>> make_topics(const Circumstances& circumstances) {
  const bool has_times = circumstances.has_times;
  std::vector<std::unique_ptr<Topic>> topics;
  topics.push_back(std::make_unique<PdoSettingTopic>());
  topics.push_back(std::make_unique<PdoFrameTopic>());
  topics.push_back(std::make_unique<NmtTopic>(circumstances.hears_all));
  topics.push_back(std::make_unique<SyncTopic>(has_times));
  topics.push_back(std::make_unique<ErrorControlTopic>(has_times));
  topics.push_back(std::make_unique<EmcyTopic>());
  topics.push_back(std::make_unique<DriveTopic>(has_times));
  topics.push_back(std::make_unique<StorageTopic>(has_times));
  if (circumstances.hears_all) topics.push_back(std::make_unique<LssTopic>(has_times));
  topics.push_back(std::make_unique<BusTopic>(has_times ? circumstances.bit_rate : 0));
  topics.push_back(std::make_unique<ObjectTopic>());  // behind those that know more of a transfer
  return topics;
}

}  // namespace audit
