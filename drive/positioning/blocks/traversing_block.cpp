#include "drive/positioning/blocks/traversing_block.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace drive {

std::size_t BlockTable::size() const noexcept {
  return std::min<std::size_t>(static_cast<std::size_t>(settings_.block_count), kTraversingBlocks);
}

TraversingBlock BlockTable::at(std::size_t entry) const noexcept {
  return {.number = settings_.block_number[entry],
          .task = static_cast<BlockTask>(settings_.block_task[entry]),
          .parameter = settings_.block_task_parameter[entry],
          .mode = static_cast<std::uint16_t>(settings_.block_task_mode[entry]),
          .position = static_cast<double>(settings_.block_position[entry]),
          .velocity = settings_.block_velocity[entry],
          .acceleration = settings_.block_acceleration[entry],
          .deceleration = settings_.block_deceleration[entry]};
}

std::optional<TraversingBlock> BlockTable::find(int number) const noexcept {
  for (std::size_t entry = 0; entry < size(); ++entry) {
    if (number < 0 || settings_.block_number[entry] != number) continue;
    const TraversingBlock block = at(entry);
    if (!block.is_hidden()) return block;
  }
  return std::nullopt;
}

std::optional<TraversingBlock> BlockTable::after(int number) const noexcept {
  std::optional<TraversingBlock> found;
  for (std::size_t entry = 0; entry < size(); ++entry) {
    if (settings_.block_number[entry] <= number) continue;
    const TraversingBlock block = at(entry);
    if (!block.is_hidden() && (!found || block.number < found->number)) found = block;
  }
  return found;
}

bool BlockTable::is_twice(int number) const noexcept {
  const auto first = settings_.block_number.begin();
  return std::count(first, first + static_cast<std::ptrdiff_t>(size()), number) > 1;
}

void sort_blocks(PositionerSettings& settings) noexcept {
  std::array<std::size_t, kTraversingBlocks> order{};
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::size_t entry) {
    const std::int32_t number = settings.block_number[entry];
    return number < 0 ? std::numeric_limits<std::int32_t>::max() : number;
  };
  // Each place from the front gets the lowest of the rest; equal numbers keep their order.
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::size_t lowest = i;
    for (std::size_t k = i + 1; k < order.size(); ++k)
      if (key(order[k]) < key(order[lowest])) lowest = k;
    std::rotate(order.begin() + static_cast<std::ptrdiff_t>(i),
                order.begin() + static_cast<std::ptrdiff_t>(lowest),
                order.begin() + static_cast<std::ptrdiff_t>(lowest) + 1);
  }
  const auto arrange = [&](auto& table) {
    const auto before = table;
    for (std::size_t i = 0; i < order.size(); ++i) table[i] = before[order[i]];
  };
  arrange(settings.block_position);
  arrange(settings.block_velocity);
  arrange(settings.block_acceleration);
  arrange(settings.block_deceleration);
  arrange(settings.block_task);
  arrange(settings.block_task_parameter);
  arrange(settings.block_task_mode);
  arrange(settings.block_number);
}

}  // namespace drive
