#include "tests/fuzz/worlds.hpp"

namespace fuzz {
namespace {

using canopen::Policy;
using canopen::TypeRange;

constexpr std::array kFewTypes{TypeRange{0, 240}, TypeRange{254, 255}};

/// Everything allowed; everything refused; what lies between, with a start into Operational.
const std::array kPolicies{
    Policy{},
    Policy{.unknown_command = canopen::UnknownCommand::Stop,
           .error_control_conflict = canopen::ErrorControlConflict::Refuse,
           .error_keeping = canopen::ErrorKeeping::Owner,
           .extended_identifiers = false,
           .sdo_block = false,
           .pdo_changes_in_operational = false,
           .dummy_types = 0,
           .tpdo_types = kFewTypes},
    Policy{.start_state = canopen::NmtState::Operational,
           .error_control_conflict = canopen::ErrorControlConflict::Refuse,
           .sdo_timeout = std::chrono::milliseconds{500},
           .count_follows_entries = true},
};

/// Told time goes on from run to run; 64 bits hold it for 292 years.
constexpr canopen::TimePoint kEndOfTime{std::chrono::years{200}};

}  // namespace

Worlds::Worlds() {
  for (const Policy& policy : kPolicies) worlds_.push_back(std::make_unique<World>(policy));
}

void Worlds::trace() noexcept {
  for (const auto& world : worlds_) world->station.trace();
}

std::uint64_t Worlds::play(std::span<const std::uint8_t> input) {
  if (input.empty()) return 0;
  const std::size_t which = input.front() % worlds_.size();
  if (worlds_[which]->station.now() > kEndOfTime) worlds_[which] = std::make_unique<World>(kPolicies[which]);
  World& world = *worlds_[which];
  world.station.reset();
  world.events.play(input.subspan(1));
  return world.station.transcript();
}

}  // namespace fuzz
