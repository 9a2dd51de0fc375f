#include "audit/nmt/nmt_topic.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "audit/nmt/nmt_rules.hpp"
#include "libcanopen/base/object_index.hpp"
#include "libcanopen/sdo/command.hpp"
#include "meaning/words.hpp"

namespace audit {

namespace rules = nmt_rules;

using canopen::NmtCommand;
using canopen::NmtState;
using meaning::Role;

namespace {

constexpr std::uint8_t kCommandBytes = 2;
constexpr std::uint8_t kToggle = 0x80;
constexpr unsigned kMostRepetitions = 3;
/// Time that a master has to notice that a node has booted, or to start the last one.
constexpr canopen::Duration kPatience = std::chrono::seconds{3};
/// A master may look from then on whether a node is there that it has reset.
constexpr canopen::Duration kLookFirst = std::chrono::milliseconds{500};
/// A node that has not booted within this time is not there.
constexpr canopen::Duration kLongestBoot = std::chrono::seconds{10};

/// Whether a frame of @p role shows that a master is at work.
bool is_of_master(Role role) noexcept {
  return role == Role::Nmt || role == Role::Sync || role == Role::Rpdo || role == Role::SdoRequest ||
         role == Role::Guarding;
}

/// Whether no master has led @p node anywhere since it booted.
bool is_left(const Node& node) noexcept {
  return !node.told || (node.told->frame.data[1] == 0 && node.told->at <= node.boot_up->at);
}

bool is_abort(const canopen::Frame& frame) noexcept {
  return canopen::sdo::CommandByte{frame.data[0]}.request() == canopen::sdo::Request::Abort;
}

/// Whether @p passage looks whether a node is there that was reset by @p told, as the boot slave of CiA 302-2
/// does.
bool looks(const Passage& passage, const Heard& told) noexcept {
  const auto command = canopen::sdo::CommandByte{passage.frame().data[0]};
  return command.request() == canopen::sdo::Request::InitiateUpload &&
         canopen::sdo::address_in(passage.frame()).index == canopen::object::kDeviceType &&
         passage.at() - told.at >= kLookFirst;
}

bool is_command(std::uint8_t byte) noexcept {
  switch (static_cast<NmtCommand>(byte)) {
    case NmtCommand::Start:
    case NmtCommand::Stop:
    case NmtCommand::EnterPreOperational:
    case NmtCommand::ResetNode:
    case NmtCommand::ResetCommunication:
      return true;
  }
  return false;
}

std::string error_control_words(const canopen::Frame& frame) {
  const auto state = static_cast<NmtState>(frame.data[0] % kToggle);
  return state == NmtState::Initialising ? "boot-up" : std::string{canopen::name_of(state)};
}

/// The state that @p command keeps a node in; nothing for resets.
std::optional<NmtState> state_of(NmtCommand command) noexcept {
  if (command == NmtCommand::Start) return NmtState::Operational;
  if (command == NmtCommand::Stop) return NmtState::Stopped;
  if (command == NmtCommand::EnterPreOperational) return NmtState::PreOperational;
  return std::nullopt;
}

}  // namespace

void NmtTopic::on_frame(const Passage& passage, const Scene& scene) {
  if (passage.heard.is_error) return;
  if (rebooted_ > 0 && is_of_master(passage.meaning.role)) look_for_unnoticed(passage, scene);
  if (passage.meaning.role == Role::Nmt) take_command(passage, scene);
  if (passage.meaning.role == Role::SdoRequest) take_request(passage, scene);
  if (passage.meaning.role == Role::ErrorControl) take_error_control(passage, scene);
}

void NmtTopic::take_command(const Passage& passage, const Scene& scene) {
  const canopen::Frame& frame = passage.frame();
  Findings& findings = scene.findings;
  if (frame.length != kCommandBytes || frame.remote)
    return findings.add(rules::kLength, 0, {passage.heard}, [&] { return fmt::format("{} bytes", frame.length); });
  const std::uint8_t id = frame.data[1];
  if (!is_command(frame.data[0]))
    return findings.add(rules::kCommand, 0, {passage.heard}, [&] { return fmt::format("{}", frame.data[0]); });
  if (id >= Network::kNodes)
    return findings.add(rules::kNodeId, 0, {passage.heard}, [&] { return fmt::format("node {}", id); });
  if (id != 0) return command(scene.network.node(id), passage, scene, true);
  const auto& nodes = scene.network.nodes();
  const auto state = state_of(static_cast<NmtCommand>(frame.data[0]));
  const bool is_too_early =
      std::ranges::none_of(nodes, [](const Node& node) { return node.is_there && !node.resets; });
  const bool is_of_use =
      std::ranges::any_of(nodes, [state](const Node& node) { return node.is_there && node.state != state; });
  for (const Node& node : nodes)
    if (node.is_there) command(node, passage, scene, hears_all_ && (node.resets ? is_too_early : !is_of_use));
}

/// @p is_judged: a command to all nodes that some are ready for and need is right.
void NmtTopic::command(const Node& node, const Passage& passage, const Scene& scene, bool is_judged) {
  const auto order = static_cast<NmtCommand>(passage.frame().data[0]);
  Course& course = courses_[node.id];
  if (course.rebooted) --rebooted_;
  course.rebooted.reset();
  course.was_started = order == NmtCommand::Start;
  const auto state = state_of(order);
  const auto words = [&] { return meaning::service_of(passage.frame()); };
  scene.time_lines[node.id].add(passage.heard, words());
  if (!is_judged) {
    course.repetitions = 0;
    return;
  }
  if (node.resets && state) {
    scene.findings.add(rules::kBeforeBootUp, node.id, {*node.told, passage.heard}, words);
    return;
  }
  const bool is_of_use = !state || node.state != state || !node.is_there;
  course.repetitions = is_of_use ? 0 : course.repetitions + 1;
  if (course.repetitions == kMostRepetitions)
    scene.findings.add(rules::kRepeated, node.id, {node.told.value_or(passage.heard), passage.heard}, words);
}

void NmtTopic::take_request(const Passage& passage, const Scene& scene) {
  const Node& node = scene.network.node(passage.meaning.node);
  Course& course = courses_[node.id];
  if (course.rebooted) --rebooted_;
  course.rebooted.reset();
  const bool boots = node.resets && (node.is_there || node.told->frame.data[1] == node.id) &&
                     passage.at() - node.told->at < kLongestBoot;
  if (is_abort(passage.frame()) || (boots && !node.is_there && looks(passage, *node.told))) return;
  const Rule* const rule = boots                             ? &rules::kSdoBeforeBootUp
                           : node.state == NmtState::Stopped ? &rules::kSdoWhenStopped
                                                             : nullptr;
  if (rule != nullptr)
    scene.findings.add(*rule, node.id, {node.told.value_or(passage.heard), passage.heard},
                       [&] { return meaning::words_of(passage.frame(), passage.meaning, node.description); });
}

void NmtTopic::take_error_control(const Passage& passage, const Scene& scene) {
  const Node& node = scene.network.node(passage.meaning.node);
  const bool is_boot_up = passage.is_boot_up();
  const bool is_other = !node.state || passage.frame().data[0] % kToggle != static_cast<std::uint8_t>(*node.state);
  if (is_other || is_boot_up) scene.time_lines[node.id].add(passage.heard, error_control_words(passage.frame()));
  const bool runs = passage.frame().data[0] % kToggle == static_cast<std::uint8_t>(NmtState::Operational);
  if (runs && courses_[node.id].rebooted) {  // it starts by itself
    courses_[node.id].rebooted.reset();
    --rebooted_;
  }
  const bool was_started = courses_[node.id].was_started && node.state == NmtState::Operational;
  if (!is_boot_up || node.resets || !was_started || courses_[node.id].rebooted) return;
  courses_[node.id].rebooted = passage.heard;
  ++rebooted_;
}

void NmtTopic::look_for_unnoticed(const Passage& passage, const Scene& scene) {
  for (Course& course : courses_) {
    if (!course.rebooted || passage.at() - course.rebooted->at < kPatience) continue;
    const auto node = static_cast<std::uint8_t>(&course - courses_.data());
    scene.findings.add(rules::kRebootUnnoticed, node, {*course.rebooted, passage.heard}, [&] {
      return fmt::format("nothing was sent to it for {} s",
                         std::chrono::duration_cast<std::chrono::seconds>(kPatience).count());
    });
    course.rebooted.reset();
    course.was_started = false;
    --rebooted_;
  }
}

void NmtTopic::on_end(canopen::Duration at, const Scene& scene) {
  const auto& nodes = scene.network.nodes();
  const auto runs = [](const Node& node) { return node.is_there && node.state == NmtState::Operational; };
  const auto started = std::ranges::find_if(nodes, runs);
  if (started == nodes.end() || !started->told) return;
  for (const Node& node : nodes) {
    const bool waits = node.is_there && node.boot_up && node.state == NmtState::PreOperational && !node.resets &&
                       at - node.boot_up->at >= kPatience;
    const bool is_slave = node.values.size() != 0 || node.error_control;  // else the boot-up may be the master's
    if (waits && is_slave && is_left(node))
      scene.findings.add(rules::kForgotten, node.id, {*node.boot_up, *started->told},
                         [&] { return fmt::format("node {} was started", started->id); });
  }
}

}  // namespace audit
