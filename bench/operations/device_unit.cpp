#include "bench/operations/device_unit.hpp"

#include <array>
#include <bit>

#include "drive/base/scaling.hpp"

namespace bench {

using namespace std::chrono_literals;

void DeviceUnit::enter_operational() {
  unit.on_frame({.id = 0x000, .length = 2, .data = {0x01, kNodeId}}, now);
  check(unit.node().state() == canopen::NmtState::Operational, "NMT start");
}

void DeviceUnit::download(canopen::sdo::Address at, std::uint32_t value, unsigned size) {
  unit.on_frame(sdo_request(kNodeId, expedited_download(size), at, value), now);
  check(sink.last.id == 0x580 + kNodeId && sink.last.data[0] == kDownloadDone, "SDO download");
}

std::uint32_t DeviceUnit::upload(canopen::sdo::Address at) {
  unit.on_frame(sdo_request(kNodeId, kUpload, at), now);
  return canopen::load<std::uint32_t>(&sink.last.data[4]);
}

void DeviceUnit::set_cycle(float milliseconds) {
  constexpr std::uint16_t kWindow = 0x41B6, kDeviceFilter = 0x2000 + 9, kPeriod = 0x2000 + 8848;
  constexpr std::uint32_t kDriveConfiguration = 3;
  download({kWindow, 0}, 1, 2);
  download({kDeviceFilter, 0}, kDriveConfiguration, 2);
  download({kPeriod, 0}, std::bit_cast<std::uint32_t>(milliseconds), 4);
  unit.on_frame(sdo_request(kNodeId, expedited_download(2), {kDeviceFilter, 0}, 0), now);
  check(unit.cycle() == device::CycleClock::period_of(milliseconds), "process-data cycle");
}

void DeviceUnit::pass(canopen::Duration time) {
  for (const canopen::TimePoint end = now + time; now < end;) {
    now += unit.cycle();
    unit.on_time(now);
  }
}

void DeviceUnit::turn_axes() {
  constexpr double kSpeed = 100.0;  // rad/s
  constexpr std::array<std::uint16_t, 3> kControlwords{0x06, 0x07, 0x0F};
  constexpr std::uint16_t kStride = 0x800;
  const auto axes = unit.unit().axes();
  const auto of_axis = [](unsigned index, std::size_t axis) {
    return canopen::sdo::Address{static_cast<std::uint16_t>(index + kStride * axis), 0};
  };
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const drive::BusScaling scaling{axes[axis].references()};
    download(of_axis(0x60FF, axis), static_cast<std::uint32_t>(scaling.speed_to_bus(kSpeed)), 4);
  }
  for (const std::uint16_t word : kControlwords) {
    for (std::size_t axis = 0; axis < axes.size(); ++axis) download(of_axis(0x6040, axis), word, 2);
    pass(12ms);
  }
  pass(5s);
  for (const drive::Axis& axis : axes)
    check(axis.actual().speed > 0.99 * kSpeed && axis.actual().speed < 1.01 * kSpeed, "axis at speed");
}

}  // namespace bench
