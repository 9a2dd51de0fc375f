#include "audit/emcy/emcy_topic.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "audit/emcy/emcy_rules.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "meaning/words.hpp"

namespace audit {

namespace rules = emcy_rules;

using meaning::Role;

namespace {

constexpr unsigned kMostRepetitions = 5;
constexpr canopen::Duration kPatience = std::chrono::seconds{2};
/// Errors of the communication that stop nothing (CiA 301, 7.2.7.1): CAN overrun, error passive, back from
/// bus-off.
constexpr std::array<std::uint16_t, 3> kPassing{0x8110, 0x8120, 0x8140};

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

void EmcyTopic::take_rpdo(const Passage& passage, const Scene& scene) {
  canopen::Frame& last = rpdos_[passage.meaning];
  const bool is_same = last == passage.frame();
  last = passage.frame();
  std::optional<Open>& open = open_[passage.meaning.node];
  if (!open) return;
  if (!is_same) return open.reset();
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
