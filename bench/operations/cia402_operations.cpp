#include <cmath>
#include <memory>

#include "bench/operations/frames.hpp"
#include "bench/operations/operation.hpp"
#include "cia402/face.hpp"
#include "device/device.hpp"

namespace bench {
namespace {

using canopen::Frame;

constexpr std::uint16_t kStride = 0x800;
constexpr std::uint32_t kSynchronousPositionMode = 8;
constexpr std::uint32_t kInvalid = 0x80000000;
constexpr std::uint32_t kCosine = 20000;  // units

/// A CiA 402 device on a counting bus, with a clock that the measurement moves.
struct Cia402Device final : device::Listener {
  explicit Cia402Device(std::size_t axes = 1)
      : configuration{.node_id = kNodeId, .axes = std::vector<cia402::AxisSetup>(axes)},
        device{cia402::unit_configuration(configuration),
               [this](unit::Runner& runner) {
                 return std::make_unique<cia402::Face>(configuration, runner, sink, *this, *this);
               },
               *this} {
    device.start(now);
  }

  static constexpr std::uint8_t kNodeId = 2;

  void on_subscriptions_changed() noexcept override {}
  void on_foreign_frame(std::uint32_t) noexcept override {}

  void download(canopen::sdo::Address at, std::uint32_t value, unsigned size) {
    device.on_frame(sdo_request(kNodeId, expedited_download(size), at, value), now);
    check(sink.last.id == 0x580 + kNodeId && sink.last.data[0] == kDownloadDone, "SDO download");
  }
  void pass(canopen::Duration time) {
    for (const canopen::TimePoint end = now + time; now < end;) {
      now += device.cycle();
      device.on_time(now);
    }
  }
  /// Operational, all axes enabled in csp, with set-points at @p type of the RPDOs 3 of each axis.
  void enable(std::uint8_t type) {
    const std::size_t axes = device.unit().axes().size();
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const auto rpdo = static_cast<std::uint16_t>(0x1402 + 0x40 * axis);
      const auto tpdo = static_cast<std::uint16_t>(0x1802 + 0x40 * axis);
      download({rpdo, 1}, kInvalid, 4);
      map_set_points(axis);
      download({rpdo, 1}, set_points(axis), 4);
      download({rpdo, 2}, type, 1);
      download({tpdo, 1}, kInvalid, 4);
      map_position(axis);
      download({tpdo, 1}, static_cast<std::uint32_t>(0x40000190 + axis), 4);
      download({tpdo, 2}, type, 1);
      download({of_axis(0x60C2, axis), 1}, 1, 1);
      download({of_axis(0x6060, axis), 0}, kSynchronousPositionMode, 1);
    }
    device.on_frame({.id = 0x000, .length = 2, .data = {0x01, kNodeId}}, now);
    for (const std::uint32_t word : {0x06U, 0x07U, 0x0FU})
      for (std::size_t axis = 0; axis < axes; ++axis)  // TPDOs follow the answer
        device.on_frame(sdo_request(kNodeId, expedited_download(2), {of_axis(0x6040, axis), 0}, word), now);
    pass(std::chrono::milliseconds{20});
  }
  static std::uint16_t of_axis(unsigned index, std::size_t axis) {
    return static_cast<std::uint16_t>(index + kStride * axis);
  }
  static std::uint32_t set_points(std::size_t axis) { return static_cast<std::uint32_t>(0x210 + axis); }
  /// Controlword and target position.
  void map_set_points(std::size_t axis) { map(0x1602, axis, 0x60400010, 0x607A0020); }
  /// Statusword and actual position.
  void map_position(std::size_t axis) { map(0x1A02, axis, 0x60410010, 0x60640020); }
  void map(unsigned record, std::size_t axis, std::uint32_t first, std::uint32_t second) {
    const auto index = static_cast<std::uint16_t>(record + 0x40 * axis);
    const auto on_axis = static_cast<std::uint32_t>(kStride * axis) << 16;
    download({index, 0}, 0, 1);
    download({index, 1}, first + on_axis, 4);
    download({index, 2}, second + on_axis, 4);
    download({index, 0}, 2, 1);
  }

  canopen::TimePoint now{std::chrono::hours{1}};
  CountingSink sink;
  cia402::Configuration configuration;
  device::Device device;
};

struct Upload {
  Upload() {
    step();
    check(answers(bus.sink.last, request, 0x00020192), "SDO upload of 1000h");
  }
  void step() { bus.device.on_frame(request, bus.now); }

  Cia402Device bus;
  Frame request = sdo_request(Cia402Device::kNodeId, kUpload, {0x1000, 0});
};

/// A controlword that changes nothing acts all the same.
struct Controlword {
  Controlword() { bus.enable(255); }
  void step() { bus.device.on_frame(frame, bus.now); }

  Cia402Device bus;
  Frame frame{.id = 0x202, .length = 2, .data = {0x0F, 0x00}};
};

/// What a master of csp does with an axis every millisecond: set-points, SYNC, the cycle.
template <std::size_t Axes>
struct CyclicPosition {
  CyclicPosition() {
    bus.enable(1);
    for (int i = 0; i < 100; ++i) step();
    check(bus.device.axis(Axes).actual().pulses_enabled, "an axis in csp");
    check(std::abs(bus.device.axis(Axes).actual().speed) > 0.1, "an axis that follows");
  }
  void step() {
    ++count;
    const auto position = static_cast<std::int32_t>(std::lround(kCosine * (1.0 - std::cos(1e-2 * count))));
    for (std::size_t axis = 0; axis < Axes; ++axis) {
      Frame frame{.id = Cia402Device::set_points(axis), .length = 6, .data = {0x0F, 0x00}};
      canopen::store(&frame.data[2], position);
      bus.device.on_frame(frame, bus.now);
    }
    bus.device.on_frame({.id = 0x080}, bus.now);
    bus.pass(std::chrono::milliseconds{1});
  }

  Cia402Device bus{Axes};
  int count = 0;
};

struct RestingTick {
  RestingTick() {
    bus.pass(std::chrono::seconds{1});
    check(bus.device.next_deadline() == canopen::kNever, "a device at rest");
  }
  void step() { bus.device.on_time(bus.now); }

  Cia402Device bus;
};

}  // namespace

std::vector<OperationRow> cia402_operations() {
  return {
      {"cia402/sdo_upload", "CiA 402 device: SDO expedited upload, the same object", make<Upload>},
      {"cia402/rpdo", "CiA 402 device: RPDO with a controlword, which acts", make<Controlword>},
      {"cia402/csp", "CiA 402 device: set-point, SYNC, TPDO and 1 ms of an axis in csp", make<CyclicPosition<1>>},
      {"cia402/csp_8", "CiA 402 device: the same of 8 axes", make<CyclicPosition<8>>},
      {"cia402/tick_resting", "CiA 402 device: tick with nothing due", make<RestingTick>},
  };
}

}  // namespace bench
