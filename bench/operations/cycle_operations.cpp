#include "bench/operations/cycle_operations.hpp"

#include <array>
#include <vector>

#include "bench/operations/device_unit.hpp"
#include "device/pdo/pdo_objects.hpp"

namespace bench {
namespace {

using canopen::Frame;
using device::pdo::Direction;

constexpr std::size_t kAxes = drive::kMostAxes;
constexpr std::uint16_t kOfAnAxis = 4;  ///< PDOs of the predefined set

/// A unit of eight axes that turn, without PDOs.
struct QuietUnit {
  QuietUnit() : bus{kAxes} {
    bus.set_cycle(4.0F);
    bus.turn_axes();
    const std::uint64_t before = bus.sink.count;
    step();
    check(bus.sink.count == before, "no frame in a cycle");
    for (const drive::Axis& axis : bus.unit.unit().axes()) check(axis.actual().speed > 50.0, "axes that turn");
  }
  void step() {
    bus.now += bus.unit.cycle();
    bus.unit.on_time(bus.now);
  }

  DeviceUnit bus;
};

/// A unit of eight axes that turn, with 25 valid RPDOs and as many TPDOs as its cycle allows: each TPDO has a
/// position in it, so that every cycle sends it.
struct FullUnit {
  static constexpr std::size_t kRpdos = device::PdoRules::kMostReceivePdos;
  static constexpr std::uint16_t kFirstRpdo = 0x210, kFirstTpdo = 0x190;

  explicit FullUnit(float milliseconds) : bus{kAxes} {
    bus.set_cycle(milliseconds);
    for (std::size_t i = 0; i < kRpdos; ++i)
      give(Direction::Receive, i / kOfAnAxis, i % kOfAnAxis, kFirstRpdo + i);
    // The first TPDO of every axis first.
    tpdos = std::min(kAxes * kOfAnAxis, static_cast<std::size_t>(8.0F * milliseconds));
    for (std::size_t place = 0; place < kOfAnAxis; ++place) take_away(Direction::Transmit, 0, place);
    for (std::size_t i = 0; i < tpdos; ++i) give(Direction::Transmit, i % kAxes, i / kAxes, kFirstTpdo + i);
    bus.enter_operational();
    bus.turn_axes();
    fill_frames();
    check_cycle();
  }

  void receive() {
    for (const Frame& frame : frames) bus.unit.on_frame(frame, bus.now);
  }
  void end_cycle() {
    bus.now += bus.unit.cycle();
    bus.unit.on_time(bus.now);
  }

  DeviceUnit bus;
  std::size_t tpdos = 0;
  std::array<Frame, kRpdos> frames{};

 private:
  static canopen::sdo::Address record(Direction direction, std::size_t axis, std::size_t place,
                                      device::pdo::Part part, std::uint8_t sub_index) {
    const auto pdo = device::pdo::of_axis(direction, axis + 1, static_cast<std::uint16_t>(place));
    return {device::pdo::index_of(pdo, part), sub_index};
  }
  void take_away(Direction direction, std::size_t axis, std::size_t place) {
    bus.download(record(direction, axis, place, device::pdo::Part::Communication, 1), 0xC0000000, 4);
  }
  void give(Direction direction, std::size_t axis, std::size_t place, std::size_t identifier) {
    constexpr std::uint32_t kPosition = 0x60630020, kAxisStride = 0x08000000, kNoRemote = 0x40000000;
    const bool sends = direction == Direction::Transmit;
    take_away(direction, axis, place);
    if (sends)
      bus.download(record(direction, axis, place, device::pdo::Part::Mapping, 2),
                   kPosition + kAxisStride * static_cast<std::uint32_t>(axis), 4);
    bus.download(record(direction, axis, place, device::pdo::Part::Communication, 1),
                 (sends ? kNoRemote : 0) + static_cast<std::uint32_t>(identifier), 4);
  }
  /// Controlword and speed as they are.
  void fill_frames() {
    constexpr std::array<std::uint8_t, kOfAnAxis> kLengths{2, 6, 4, 8};
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const std::size_t place = i % kOfAnAxis;
      Frame& frame = frames[i];
      frame.id = static_cast<std::uint32_t>(kFirstRpdo + i);
      frame.length = kLengths[place];
      canopen::store(frame.data.data(), std::uint16_t{0x000F});
      if (place == 1 || place == 3)
        canopen::store(&frame.data[2],
                       bus.upload({static_cast<std::uint16_t>(0x60FF + 0x800 * (i / kOfAnAxis)), 0}));
    }
  }
  void check_cycle() {
    receive();
    const std::uint64_t before = bus.sink.count;
    end_cycle();
    check(bus.sink.count - before == tpdos, "number of TPDOs in a cycle");
    check(bus.unit.unit().object(drive::kControlUnitNumber)->messages().alarms().empty(), "no alarm");
    for (const drive::Axis& axis : bus.unit.unit().axes()) check(axis.actual().speed > 50.0, "axes that turn");
  }
};

/// The PDOs of one cycle and the cycle.
template <int kMilliseconds>
struct Cycle {
  void step() {
    unit.receive();
    unit.end_cycle();
  }
  FullUnit unit{static_cast<float>(kMilliseconds)};
};

}  // namespace

std::vector<OperationRow> cycle_operations() {
  return {
      {"device/cycle_4ms", "unit: 8 axes at speed, 25 RPDOs, a cycle of 4 ms, 32 TPDOs", make<Cycle<4>>},
      {"device/cycle_1ms", "unit: 8 axes at speed, 25 RPDOs, a cycle of 1 ms, 8 TPDOs", make<Cycle<1>>},
      {"device/cycle_quiet", "unit: 8 axes at speed, a cycle of 4 ms, no PDO", make<QuietUnit>},
  };
}

}  // namespace bench
