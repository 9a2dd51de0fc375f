#include "bench/device_unit.hpp"

#include <array>

#include "drive/scaling.hpp"

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

void DeviceUnit::pass(canopen::Duration time) {
  for (const canopen::TimePoint end = now + time; now < end;) {
    now += device::Device::kCycle;
    unit.on_time(now);
  }
}

void DeviceUnit::turn_axis() {
  constexpr double kSpeed = 100.0;  // rad/s
  constexpr std::array<std::uint16_t, 3> kControlwords{0x06, 0x07, 0x0F};
  const drive::BusScaling scaling{unit.axis().parameters()};
  download({0x60FF, 0}, static_cast<std::uint32_t>(scaling.speed_to_bus(kSpeed)), 4);
  for (const std::uint16_t word : kControlwords) {
    download({0x6040, 0}, word, 2);
    pass(3 * device::Device::kCycle);
  }
  pass(5s);
  check(unit.axis().actual().speed > 0.99 * kSpeed && unit.axis().actual().speed < 1.01 * kSpeed, "axis at speed");
}

}  // namespace bench
