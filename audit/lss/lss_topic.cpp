#include "audit/lss/lss_topic.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "audit/lss/lss_rules.hpp"
#include "audit/network/network.hpp"

namespace audit {

namespace rules = lss_rules;

namespace {

constexpr std::uint8_t kFrameBytes = 8;
constexpr std::uint8_t kSwitchGlobal = 0x04, kSwitchAnswer = 0x44;
constexpr std::uint8_t kConfigureNodeId = 0x11, kConfigureBitTiming = 0x13, kActivate = 0x15, kStore = 0x17;
constexpr std::uint8_t kFastscan = 0x51, kIdentified = 0x4F;
constexpr std::size_t kBitPlace = 5, kSubPlace = 6, kNextPlace = 7;  // in a fastscan
constexpr std::uint8_t kFirstInquiry = 0x5A, kLastInquiry = 0x5E;
constexpr std::uint8_t kLastNodeId = 127, kNoNodeId = 255;
/// A command that comes so soon has not waited for an answer.
constexpr canopen::Duration kImpatience = std::chrono::milliseconds{5};
constexpr canopen::Duration kPatience = std::chrono::seconds{3};

bool is_inquiry(std::uint8_t command) noexcept {
  return command >= kFirstInquiry && command <= kLastInquiry;
}

/// The last command of a fastscan: the node that answers is switched to configuration (CiA 305 3.8.3).
bool ends_fastscan(const canopen::Frame& frame) noexcept {
  return frame.data[0] == kFastscan && frame.data[kBitPlace] == 0 &&
         frame.data[kNextPlace] < frame.data[kSubPlace];
}

bool is_configuration(std::uint8_t command) noexcept {
  return command == kConfigureNodeId || command == kConfigureBitTiming || command == kActivate ||
         command == kStore;
}

}  // namespace

void LssTopic::on_frame(const Passage& passage, const Scene& scene) {
  if (passage.heard.is_error) return;
  const bool is_lss =
      passage.meaning.role == meaning::Role::LssRequest || passage.meaning.role == meaning::Role::LssResponse;
  if (is_lss) last_at_ = passage.at();
  if (passage.meaning.role == meaning::Role::LssRequest) return take_command(passage.heard, scene);
  if (passage.meaning.role == meaning::Role::LssResponse) return take_answer(passage.heard);
  if (passage.is_reset()) switched_.reset();
}

void LssTopic::take_answer(const Heard& heard) {
  asked_.reset();
  const std::uint8_t answer = heard.frame.data[0];
  const bool is_switched = answer == kSwitchAnswer || (answer == kIdentified && ends_fastscan(last_));
  if (is_switched || to_nobody_) {  // who answers a configuration was switched before the log begins
    switched_ = heard;
    is_global_ = false;
  }
  to_nobody_.reset();
}

void LssTopic::report_unanswered(const Scene& scene) {
  if (to_nobody_)
    scene.findings.add(rules::kOrder, 0, {*to_nobody_},
                       [&] { return fmt::format("command {:02X}h", to_nobody_->frame.data[0]); });
  to_nobody_.reset();
}

void LssTopic::take_command(const Heard& heard, const Scene& scene) {
  if (heard.frame.length != kFrameBytes)
    return scene.findings.add(rules::kLength, 0, {heard},
                              [&] { return fmt::format("{} bytes", heard.frame.length); });
  const std::uint8_t command = heard.frame.data[0];
  if (judges_times_ && asked_ && heard.at - asked_->at < kImpatience)
    scene.findings.add(rules::kOverlap, 0, {*asked_, heard},
                       [&] { return fmt::format("{:02X}h behind {:02X}h", command, asked_->frame.data[0]); });
  report_unanswered(scene);
  asked_.reset();
  last_ = heard.frame;
  if (command == kSwitchGlobal) return take_switch(heard);
  if (is_configuration(command) || is_inquiry(command)) {
    if (command != kActivate) asked_ = heard;
    if (is_configuration(command)) judge_configuration(heard, scene);
  }
}

void LssTopic::take_switch(const Heard& heard) {
  is_global_ = heard.frame.data[1] != 0;
  switched_ = is_global_ ? std::optional{heard} : std::nullopt;
}

void LssTopic::judge_configuration(const Heard& heard, const Scene& scene) {
  const std::uint8_t command = heard.frame.data[0], id = heard.frame.data[1];
  if (!switched_) {
    to_nobody_ = heard;
    return;
  }
  if (command != kConfigureNodeId) return;
  if (id == 0 || (id > kLastNodeId && id != kNoNodeId))
    return scene.findings.add(rules::kNodeId, 0, {heard}, [&] { return fmt::format("node {}", id); });
  const auto there = std::ranges::count_if(scene.network.nodes(), &Node::is_there);
  if (is_global_ && there > 1)
    scene.findings.add(rules::kGlobal, 0, {*switched_, heard},
                       [&] { return fmt::format("{} nodes are there", there); });
}

void LssTopic::on_end(canopen::Duration at, const Scene& scene) {
  report_unanswered(scene);
  if (switched_ && at - last_at_ >= kPatience)
    scene.findings.add(rules::kLeftOpen, 0, {*switched_},
                       [] { return std::string{"nothing has switched them back"}; });
}

}  // namespace audit
