#include "audit/emcy/emcy_topic.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "audit/drive/drive_objects.hpp"
#include "audit/emcy/emcy_rules.hpp"
#include "audit/network/pdo_record.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "meaning/words.hpp"

namespace audit {

namespace rules = emcy_rules;

using meaning::Role;

namespace {

constexpr unsigned kMostRepetitions = 5;
constexpr canopen::Duration kPatience = std::chrono::seconds{2};
/// Errors of the communication that stop nothing (CiA 301, 7.2.7.1): CAN overrun, error passive, back from
/// bus-off, an RPDO that is too long.
constexpr std::array<std::uint16_t, 4> kPassing{0x8110, 0x8120, 0x8140, 0x8220};

bool is_controlword(const MappedObject& mapped) noexcept {
  constexpr std::uint16_t kOfAnAxis = 0x800, kLast = 0x9FFF;
  constexpr unsigned kBits = 16;
  return mapped.at.index >= drive_object::kControlword && mapped.at.index <= kLast &&
         (mapped.at.index - drive_object::kControlword) % kOfAnAxis == 0 && mapped.bits == kBits;
}

/// The controlwords in @p frame, which has @p objects.
std::vector<std::uint16_t> controlwords_in(const canopen::Frame& frame, const std::vector<MappedObject>& objects) {
  std::vector<std::uint16_t> words;
  const auto bits = canopen::load<std::uint64_t>(frame.data.data());
  for (const MappedObject& mapped : objects)
    if (is_controlword(mapped) && mapped.first_bit + mapped.bits <= 8U * frame.length)
      words.push_back(static_cast<std::uint16_t>(bits >> mapped.first_bit));
  return words;
}

}  // namespace

void EmcyTopic::on_frame(const Passage& passage, const Scene& scene) {
  if (passage.heard.is_error) return;
  switch (passage.meaning.role) {
    case Role::Emergency:
      return take_emergency(passage, scene);
    case Role::SdoRequest:
      return open_[passage.meaning.node].reset();  // it looks, or does something
    case Role::Nmt:
      return open_.fill(std::nullopt);
    case Role::Rpdo:
      return take_rpdo(passage, scene);
    default:
      return;
  }
}

void EmcyTopic::take_emergency(const Passage& passage, const Scene& scene) {
  const Node& node = scene.network.node(passage.meaning.node);
  scene.time_lines[node.id].add(passage.heard,
                                meaning::words_of(passage.frame(), passage.meaning, node.description));
  const auto code = canopen::load<std::uint16_t>(passage.frame().data.data());
  std::optional<Open>& open = open_[passage.meaning.node];
  if (code == 0)
    open.reset();
  else if (!open && std::ranges::find(kPassing, code) == kPassing.end())
    open = Open{.emergency = passage.heard};
}

/// Whether an RPDO, which was @p before, shows that the master has seen the error, or does not move the drive.
/// Only a controlword tells that, if RPDOs have one: set-points go on by themselves.
bool EmcyTopic::reacts(const canopen::Frame& before, const Passage& passage, const Network& network) const {
  const Node& node = network.node(passage.meaning.node);
  const auto objects = mapping_of(node, {.is_receive = true, .number = passage.meaning.number});
  const auto words = controlwords_in(passage.frame(), objects.value_or(std::vector<MappedObject>{}));
  if (words.empty()) return before != passage.frame() && !has_controlword(node);
  const bool enables = std::ranges::any_of(
      words, [](std::uint16_t word) { return (word & drive_object::kEnableAll) == drive_object::kEnableAll; });
  return !enables || words != controlwords_in(before, *objects);
}

/// Whether RPDOs of @p node that are in use have a controlword.
bool EmcyTopic::has_controlword(const Node& node) const {
  return std::ranges::any_of(rpdos_, [&node](const auto& rpdo) {
    if (rpdo.first.node != node.id) return false;
    const auto objects = mapping_of(node, {.is_receive = true, .number = rpdo.first.number});
    return objects && std::ranges::any_of(*objects, is_controlword);
  });
}

void EmcyTopic::take_rpdo(const Passage& passage, const Scene& scene) {
  const canopen::Frame last = std::exchange(rpdos_[passage.meaning], passage.frame());
  std::optional<Open>& open = open_[passage.meaning.node];
  if (!open) return;
  if (reacts(last, passage, scene.network)) return open.reset();
  const bool is_ignored =
      ++open->repetitions >= kMostRepetitions && passage.at() - open->emergency.at >= kPatience;
  if (!is_ignored) return;
  scene.findings.add(rules::kIgnored, passage.meaning.node, {open->emergency, passage.heard}, [&] {
    return fmt::format("error code {:04X}h, then {} times the same RPDO",
                       canopen::load<std::uint16_t>(open->emergency.frame.data.data()), open->repetitions);
  });
  open.reset();
}

}  // namespace audit
