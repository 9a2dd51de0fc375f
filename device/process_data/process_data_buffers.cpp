#include "device/process_data/process_data_buffers.hpp"

#include <algorithm>
#include <array>

#include "drive/signal_source.hpp"

namespace device {
namespace {

using pdo::Direction;

/// All that a displayed value is made of.
struct View {
  const drive::DriveUnit& unit;
  const drive::Axis& axis;
  const ProcessDataLayout& received;
  const ProcessDataLayout& sent;

  const ProcessDataLayout& layout(Direction direction) const noexcept {
    return direction == Direction::Receive ? received : sent;
  }
};

/// The object of @p words words that begins at @p place.
template <Direction Which, std::uint8_t Words>
double mapped_index(const View& view, std::size_t place) noexcept {
  const ProcessDataLayout::Item* const item = view.layout(Which).at(place);
  return item != nullptr && item->first == place && item->words == Words ? item->object->index : 0.0;
}

/// The number (from 1) of the last received word that @p packed, an input of @p object, is connected to; 0 if to
/// none of the axis of @p view.
std::size_t word_behind(const View& view, const drive::DriveObject& object, std::uint32_t packed) noexcept {
  constexpr std::uint16_t kWords = 8850, kDoubleWords = 8860, kFirstBits = 8890, kLastBits = 8893;
  if (packed <= drive::kHighestConstant) return 0;
  const drive::BicoSource source = drive::unpack(packed);
  if (drive::connected_object(view.unit, object, source) != &view.axis) return 0;
  if (source.number == kWords) return source.position + 1U;
  if (source.number == kDoubleWords) return source.position + 2U;
  const bool bits = source.number >= kFirstBits && source.number <= kLastBits;
  return bits ? source.number - kFirstBits + 1U : 0;
}

std::size_t highest_word_behind(const View& view, const drive::DriveObject& object) noexcept {
  std::size_t highest = 0;
  for (const drive::PlacedRow& placed : drive::parameters_of(object.kind())) {
    if (!drive::is_bico_input(placed.row->type)) continue;
    for (std::size_t i = 0; i < placed.row->count; ++i) {
      const double input = object.read(placed.row->number, i).value_or(0.0);
      highest = std::max(highest, word_behind(view, object, static_cast<std::uint32_t>(input)));
    }
  }
  return highest;
}

std::size_t highest_source(const View& view) noexcept {
  std::size_t highest = 0;
  view.unit.for_each_object(
      [&](const drive::DriveObject& object) { highest = std::max(highest, highest_word_behind(view, object)); });
  return highest;
}

std::size_t highest_sink(const View& view) noexcept {
  constexpr std::uint16_t kWords = 8851, kDoubleWords = 8861;
  const auto is_connected = [&](std::uint16_t number, std::size_t place) {
    return view.axis.read(number, place).value_or(0.0) > 0.0;
  };
  for (std::size_t number = ProcessDataLayout::kTransmitWords; number > 0; --number) {
    if (is_connected(kWords, number - 1)) return number;
    if (number > 1 && is_connected(kDoubleWords, number - 2)) return number;
  }
  return 0;
}

/// r8867: number of the highest word [0] received [1] sent that is connected.
double highest_connected(const View& view, std::size_t direction) noexcept {
  return static_cast<double>(direction == 0 ? highest_source(view) : highest_sink(view));
}

/// A parameter and how it is found.
struct Row {
  std::uint16_t number;
  double (*show)(const View& view, std::size_t index) noexcept;
};
constexpr std::array kRows{
    Row{8750, mapped_index<Direction::Receive, 1>},
    Row{8751, mapped_index<Direction::Transmit, 1>},
    Row{8760, mapped_index<Direction::Receive, 2>},
    Row{8761, mapped_index<Direction::Transmit, 2>},
    Row{8867, highest_connected},
};

}  // namespace

const ProcessDataBuffers::Layouts& ProcessDataBuffers::layouts() const noexcept {
  if (!valid_) {
    layouts_.received.compute(dictionary_, Direction::Receive, axis_.axis_number());
    layouts_.sent.compute(dictionary_, Direction::Transmit, axis_.axis_number());
    valid_ = true;
  }
  return layouts_;
}

std::optional<double> ProcessDataBuffers::value_of(std::uint16_t number, std::size_t index) const noexcept {
  const auto* const row = std::ranges::find(kRows, number, &Row::number);
  if (row == kRows.end()) return std::nullopt;
  return row->show({unit_, axis_, received(), sent()}, index);
}

}  // namespace device
