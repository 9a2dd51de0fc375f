#include "device/free_objects.hpp"

#include <algorithm>
#include <array>

#include "device/object_index.hpp"
#include "drive/connectors.hpp"
#include "drive/scaling.hpp"

namespace device {
namespace {

/// A block of free objects that are sent, and the connector inputs behind it.
struct Block {
  std::uint16_t first;  ///< on the first axis
  std::uint16_t count;
  std::uint16_t unmapped;  ///< input by the number of the object
  std::uint16_t mapped;    ///< input by its place in the process data
  double full;             ///< 100 %
};
constexpr std::array kBlocks{
    Block{object::kTransmitWords, object::kFreeWords, 8746, 8851, 0x4000},
    Block{object::kTransmitDoubleWords, object::kFreeDoubleWords, 8748, 8861, 0x40000000},
};

/// The block of object @p index of axis @p axis, or nullptr.
const Block* block_of(std::uint16_t index, std::size_t axis) noexcept {
  const auto holds = [&](const Block& block) {
    const std::uint16_t first = object::free_on_axis(block.first, axis);
    return index >= first && index < first + block.count;
  };
  const auto* const found = std::ranges::find_if(kBlocks, holds);
  return found != kBlocks.end() ? found : nullptr;
}

}  // namespace

FreeObjects::FreeObjects(canopen::Dictionary& dictionary, const drive::DriveUnit& unit, const drive::Axis& axis,
                         const ProcessDataBuffers& buffers)
    : dictionary_{dictionary}, unit_{unit}, axis_{axis}, buffers_{buffers} {
  for (const Block& block : kBlocks) {
    const std::uint16_t first = object::free_on_axis(block.first, axis.axis_number());
    for (std::uint16_t i = 0; i < block.count; ++i)
      dictionary.own_read(static_cast<std::uint16_t>(first + i), 0, *this);
  }
}

void FreeObjects::publish() noexcept {
  for (const ProcessDataLayout::Item& item : buffers_.sent().items())
    if (block_of(item.object->index, axis_.axis_number()) != nullptr)
      dictionary_.set(*item.object, value_of(*item.object, &item));
}

canopen::Result<std::int64_t> FreeObjects::read(const canopen::Entry& entry, std::int64_t) {
  return value_of(entry, buffers_.sent().find(entry.index));
}

std::int64_t FreeObjects::value_of(const canopen::Entry& entry,
                                   const ProcessDataLayout::Item* place) const noexcept {
  const Block& block = *block_of(entry.index, axis_.axis_number());
  const auto number =
      static_cast<std::size_t>(entry.index - object::free_on_axis(block.first, axis_.axis_number()));
  const auto input =
      place != nullptr ? axis_.read(block.mapped, place->first) : axis_.read(block.unmapped, number);
  const auto source = static_cast<std::uint32_t>(input.value_or(0.0));
  const double value = drive::connected_value(unit_, axis_, source, block.full);
  return entry.size == sizeof(std::int16_t) ? drive::saturated<std::int16_t>(value)
                                            : drive::saturated<std::int32_t>(value);
}

}  // namespace device
