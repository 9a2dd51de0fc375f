#include "device/process_data/free_objects.hpp"

#include <algorithm>
#include <array>

#include "device/objects/object_index.hpp"
#include "drive/signal_source.hpp"

namespace device {
namespace {

/// A block of free objects that are sent, and the connector inputs behind it.
struct Block {
  std::uint16_t first;  ///< on the first axis
  std::uint16_t count;
  std::uint16_t input;  ///< by the number of the object
};
constexpr std::array kBlocks{
    Block{object::kTransmitWords, object::kFreeWords, 8746},
    Block{object::kTransmitDoubleWords, object::kFreeDoubleWords, 8748},
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
    : unit_{unit}, axis_{axis}, buffers_{buffers} {
  for (const Block& block : kBlocks) {
    const std::uint16_t first = object::free_on_axis(block.first, axis.axis_number());
    for (std::uint16_t i = 0; i < block.count; ++i)
      dictionary.own_read(static_cast<std::uint16_t>(first + i), 0, *this);
  }
}

canopen::Result<std::int64_t> FreeObjects::read(const canopen::Entry& entry, std::int64_t stored) {
  if (buffers_.sent().find(entry.index) != nullptr) return stored;
  const Block& block = *block_of(entry.index, axis_.axis_number());
  const auto number =
      static_cast<std::size_t>(entry.index - object::free_on_axis(block.first, axis_.axis_number()));
  const auto packed = static_cast<std::uint32_t>(axis_.read(block.input, number).value_or(0.0));
  const drive::SignalSource source{unit_, axis_, packed};
  if (entry.size == sizeof(std::int16_t)) return source.process_data<std::int16_t>();
  return source.process_data<std::int32_t>();
}

}  // namespace device
