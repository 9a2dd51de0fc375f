#include "device/process_data_buffers.hpp"

#include <algorithm>
#include <array>

#include "device/object_index.hpp"
#include "drive/connectors.hpp"
#include "drive/scaling.hpp"

namespace device {
namespace {

using pdo::Direction;

/// All that a displayed value is made of.
struct View {
  const canopen::Dictionary& dictionary;
  const drive::DriveUnit& unit;
  const drive::Axis& axis;
  const canopen::Node& node;
  const ProcessDataLayout& received;
  const ProcessDataLayout& sent;

  const ProcessDataLayout& layout(Direction direction) const noexcept {
    return direction == Direction::Receive ? received : sent;
  }
};

constexpr double kWord = 0x4000;            // 100 %
constexpr double kDoubleWord = 0x40000000;  // 100 %
constexpr unsigned kWordBits = 16;

double relative_speed(const drive::AxisParameters& parameters, std::int64_t bus) noexcept {
  const auto speed = drive::BusScaling{parameters}.speed_from_bus(static_cast<std::int32_t>(bus));
  return speed / parameters.reference_speed * kDoubleWord;
}
double relative_rpm(const drive::AxisParameters& parameters, std::int64_t bus) noexcept {
  return static_cast<double>(bus) * drive::kRpm / parameters.reference_speed * kWord;
}
double relative_torque(const drive::AxisParameters& parameters, std::int64_t bus) noexcept {
  const auto torque = drive::BusScaling{parameters}.torque_from_bus(static_cast<std::int16_t>(bus));
  return torque / parameters.reference_torque * kWord;
}

/// Objects that process data hold relative to a reference.
struct Quantity {
  std::uint16_t index;
  double (*relative)(const drive::AxisParameters& parameters, std::int64_t bus) noexcept;
};
constexpr std::array kQuantities{
    Quantity{object::kTargetVelocity, relative_speed}, Quantity{object::kVelocityActual, relative_speed},
    Quantity{object::kVelocityDemand, relative_speed}, Quantity{object::kVelocitySensorActual, relative_speed},
    Quantity{object::kVlTargetVelocity, relative_rpm}, Quantity{object::kVlVelocityDemand, relative_rpm},
    Quantity{object::kVlVelocityActual, relative_rpm}, Quantity{object::kTargetTorque, relative_torque},
    Quantity{object::kTorqueDemand, relative_torque},  Quantity{object::kTorqueActual, relative_torque},
};

/// The value of a mapped object in its words.
std::uint32_t content(const View& view, const ProcessDataLayout::Item& item) noexcept {
  const std::int64_t bus = view.dictionary.read(*item.object).value_or(0);
  const std::uint16_t index = item.object->index;
  const bool is_free = index < object::kFirstProfileObject;
  const auto* const quantity =
      is_free ? kQuantities.end() : std::ranges::find(kQuantities, object::on_first_axis(index), &Quantity::index);
  if (quantity == kQuantities.end()) return static_cast<std::uint32_t>(bus);
  const double value = quantity->relative(view.axis.parameters(), bus);
  return static_cast<std::uint32_t>(item.words == 1 ? drive::saturated<std::int16_t>(value)
                                                    : drive::saturated<std::int32_t>(value));
}

std::uint16_t word(const View& view, Direction direction, std::size_t place) noexcept {
  const ProcessDataLayout::Item* const item = view.layout(direction).at(place);
  if (item == nullptr) return 0;
  const bool upper = item->words == 2 && place == item->first;
  return static_cast<std::uint16_t>(content(view, *item) >> (upper ? kWordBits : 0));
}

std::uint32_t double_word(const View& view, Direction direction, std::size_t place) noexcept {
  return std::uint32_t{word(view, direction, place)} << kWordBits | word(view, direction, place + 1);
}

/// The object of @p words words that begins at @p place.
template <Direction Which, std::uint8_t Words>
double mapped_index(const View& view, std::size_t place) noexcept {
  const ProcessDataLayout::Item* const item = view.layout(Which).at(place);
  return item != nullptr && item->first == place && item->words == Words ? item->object->index : 0.0;
}

double received_word(const View& view, std::size_t place) noexcept {
  return static_cast<std::int16_t>(word(view, Direction::Receive, place));
}
double received_double_word(const View& view, std::size_t place) noexcept {
  return static_cast<std::int32_t>(double_word(view, Direction::Receive, place));
}
double sent_word(const View& view, std::size_t place) noexcept {
  return word(view, Direction::Transmit, place);
}
double sent_double_word(const View& view, std::size_t place) noexcept {
  return double_word(view, Direction::Transmit, place);
}
template <std::size_t Place>
double received_bits(const View& view, std::size_t) noexcept {
  return word(view, Direction::Receive, Place);
}

template <std::uint16_t First>
double free_object(const View& view, std::size_t index) noexcept {
  const std::uint16_t first = object::free_on_axis(First, view.axis.axis_number());
  return static_cast<double>(view.dictionary.stored(static_cast<std::uint16_t>(first + index), 0).value_or(0));
}
template <std::uint16_t Index>
double setpoint(const View& view, std::size_t) noexcept {
  return static_cast<double>(
      view.dictionary.stored(object::on_axis(Index, view.axis.axis_number()), 0).value_or(0));
}

/// r8843: [0] no setpoints come, [2] the bus runs.
double interface_state(const View& view, std::size_t bit) noexcept {
  constexpr std::size_t kSetpointFailure = 0, kBusRuns = 2;
  const bool runs = view.node.state() == canopen::NmtState::Operational;
  return (bit == kBusRuns && runs) || (bit == kSetpointFailure && !runs) ? 1.0 : 0.0;
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
    Row{8745, free_object<object::kReceiveWords>},
    Row{8747, free_object<object::kReceiveDoubleWords>},
    Row{8750, mapped_index<Direction::Receive, 1>},
    Row{8751, mapped_index<Direction::Transmit, 1>},
    Row{8760, mapped_index<Direction::Receive, 2>},
    Row{8761, mapped_index<Direction::Transmit, 2>},
    Row{8792, setpoint<object::kVlTargetVelocity>},
    Row{8796, setpoint<object::kTargetVelocity>},
    Row{8797, setpoint<object::kTargetTorque>},
    Row{8843, interface_state},
    Row{8850, received_word},
    Row{8853, sent_word},
    Row{8860, received_double_word},
    Row{8863, sent_double_word},
    Row{8867, highest_connected},
    Row{8890, received_bits<0>},
    Row{8891, received_bits<1>},
    Row{8892, received_bits<2>},
    Row{8893, received_bits<3>},
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
  return row->show({dictionary_, unit_, axis_, node_, received(), sent()}, index);
}

}  // namespace device
