#include "drive/messages/message_settings.hpp"

#include <algorithm>

namespace drive {
namespace {

/// p2101 by value; 4 is reserved.
constexpr std::array<std::optional<Reaction>, 7> kReactions{Reaction::None,        Reaction::Off1, Reaction::Off2,
                                                            Reaction::Off3,        std::nullopt,   Reaction::Stop2,
                                                            Reaction::ShortCircuit};

/// p2119 by value, from 1.
constexpr std::array<std::optional<Kind>, 3> kKinds{Kind::Fault, Kind::Alarm, std::nullopt};

/// The value at the place where @p numbers names @p number.
std::optional<std::uint8_t> value_for(std::uint16_t number,
                                      const std::array<std::uint16_t, MessageSettings::kCount>& numbers,
                                      const std::array<std::uint8_t, MessageSettings::kCount>& values) noexcept {
  const auto* const found = std::find(numbers.begin(), numbers.end(), number);
  if (found == numbers.end()) return std::nullopt;
  return values[static_cast<std::size_t>(found - numbers.begin())];
}

}  // namespace

std::optional<Reaction> MessageSettings::reaction_to(const FaultRow& row) const noexcept {
  const auto value = value_for(row.number, reaction_numbers, reactions);
  if (!value) return std::nullopt;
  const std::optional<Reaction> reaction = kReactions[*value];
  const bool offered = reaction && (*reaction == row.reaction || (row.alternatives & bit_of(*reaction)) != 0);
  return offered ? reaction : std::nullopt;
}

std::optional<Kind> MessageSettings::kind_of(const FaultRow& row) const noexcept {
  const auto value = value_for(row.number, type_numbers, types);
  return value ? kKinds[*value - 1U] : row.kind;
}

}  // namespace drive
