#include <array>
#include <bit>
#include <vector>

#include "bench/operations/cycle_operations.hpp"
#include "bench/operations/device_unit.hpp"
#include "bench/operations/operation.hpp"
#include "device/objects/object_rows.hpp"

namespace bench {
namespace {

using canopen::Frame;

constexpr std::uint16_t kTpdos = 4;

struct Upload {
  Upload() {
    step();
    check(answers(bus.sink.last, request, 0xFFFF0192), "SDO upload of 1000h");
  }
  void step() { bus.unit.on_frame(request, bus.now); }

  DeviceUnit bus;
  Frame request = sdo_request(DeviceUnit::kNodeId, kUpload, {0x1000, 0});
};

struct RandomUpload {
  RandomUpload() {
    for (const Frame& request : requests) {
      bus.unit.on_frame(request, bus.now);
      check((bus.sink.last.data[0] & 0x43) == 0x43, "SDO upload of a random object");
    }
  }
  void step() { bus.unit.on_frame(requests[next++ % requests.size()], bus.now); }

  DeviceUnit bus;
  std::vector<canopen::EntryDescription> rows = device::object_rows(std::array{drive::ObjectKind::Servo});
  canopen::Dictionary same{rows, DeviceUnit::kNodeId};
  std::vector<Frame> requests = random_uploads(same);
  std::size_t next = 0;
};

struct SlopeUpload {
  SlopeUpload() { check(bus.upload({0x6083, 0}) != 0, "SDO upload of 6083h"); }
  void step() { bus.unit.on_frame(request, bus.now); }

  DeviceUnit bus;
  Frame request = sdo_request(DeviceUnit::kNodeId, kUpload, {0x6083, 0});
};

struct Download {
  Download() {
    bus.download({0x60FF, 0}, 0x12345678, 4);
    check(bus.upload({0x60FF, 0}) == 0x12345678, "value after a download");
  }
  void step() {
    canopen::store(&request.data[4], ++value);
    bus.unit.on_frame(request, bus.now);
  }

  DeviceUnit bus;
  Frame request = sdo_request(DeviceUnit::kNodeId, expedited_download(4), {0x60FF, 0});
  std::uint32_t value = 0;
};

/// A parameter that the setpoint channel follows, through the window of its drive object.
struct ParameterDownload {
  ParameterDownload() {
    bus.download({0x2000 + 8630, 0}, 2, 2);
    step();
    check(bus.sink.last.data[0] == 0x60, "SDO download of p1120");
  }
  void step() {
    canopen::store(&request.data[4], times[next++ % times.size()]);
    bus.unit.on_frame(request, bus.now);
  }

  DeviceUnit bus;
  std::array<std::uint32_t, 2> times{std::bit_cast<std::uint32_t>(5.0F), std::bit_cast<std::uint32_t>(6.0F)};
  Frame request = sdo_request(DeviceUnit::kNodeId, expedited_download(4), {0x2000 + 1120, 0});
  std::size_t next = 0;
};

struct Rpdo {
  Rpdo() {
    bus.enter_operational();
    step();
    check(
        bus.upload({0x6040, 0}) == 0x0006 && bus.upload({0x60FF, 0}) == 0x00020001 && bus.upload({0x6071, 0}) == 5,
        "values of RPDO 4");
  }
  /// No cycle comes between, as in a unit that catches up.
  void step() {
    ++frame.data[2];
    bus.unit.on_frame(frame, bus.now + kLate);
  }
  static constexpr canopen::Duration kLate = std::chrono::hours{1};

  DeviceUnit bus;
  Frame frame{.id = 0x502, .length = 8, .data = {0x06, 0x00, 0x00, 0x00, 0x02, 0x00, 0x05, 0x00}};
};

struct Sync {
  Sync() {
    for (std::uint16_t pdo = 0; pdo < kTpdos; ++pdo) {
      bus.download({static_cast<std::uint16_t>(0x1800 + pdo), 2}, 1, 1);
    }
    bus.enter_operational();
    const std::uint64_t before = bus.sink.count;
    step();
    check(bus.sink.count - before == kTpdos, "number of TPDOs after SYNC");
    check(bus.sink.last.id == 0x482 && bus.sink.last.length == 6, "last TPDO after SYNC");
  }
  void step() { bus.unit.on_frame(frame, bus.now); }

  DeviceUnit bus;
  Frame frame{.id = 0x080};
};

/// A tick with the axis at speed. Every TPDO carries the position, so that each of them is sent.
struct TurningTick {
  TurningTick() {
    for (std::uint16_t pdo = 0; pdo < kTpdos; ++pdo) map_position(pdo);
    bus.enter_operational();
    bus.turn_axes();
    const std::uint64_t before = bus.sink.count;
    step();
    check(bus.sink.count - before == kTpdos, "number of TPDOs in a tick");
  }
  void step() {
    bus.now += device::Device::kCycle;
    bus.unit.on_time(bus.now);
  }
  void map_position(std::uint16_t pdo) {
    const auto communication = static_cast<std::uint16_t>(0x1800 + pdo);
    const auto mapping = static_cast<std::uint16_t>(0x1A00 + pdo);
    const std::uint32_t cob_id = bus.upload({communication, 1});
    bus.download({communication, 1}, cob_id | 0x80000000, 4);
    bus.download({mapping, 2}, 0x60630020, 4);
    bus.download({communication, 1}, cob_id, 4);
  }

  DeviceUnit bus;
};

/// The same tick with 20 words each way on IF1 beside the bus.
struct ExchangingTick : TurningTick {
  ExchangingTick() {
    constexpr std::uint16_t kBits = 2080, kSentWord = 2051, kMadeOfBits = 2089;
    for (std::uint16_t bit = 0; bit < kStatusBits; ++bit) connect({kBits, bit}, {899, bit});
    connect({kSentWord, 0}, {kMadeOfBits, 0});
    for (std::uint16_t i = 1; i < kWords; ++i) connect({kSentWord, i}, {kSources[i % kSources.size()], 0});
    step();
    check(bus.unit.unit().object(kAxis)->read(2050, kLast) == kCounted, "the last word that is received");
    check(bus.if1.sent(kAxis)[kLast] != 0, "the last word that is sent");
  }
  void step() {
    ++words[kLast - 1];
    bus.if1.receive(kAxis, words);
    TurningTick::step();
  }
  struct Place {
    std::uint16_t number, index;
  };
  void connect(const Place& input, const Place& source) {
    const auto written = bus.unit.write_parameter(kAxis, input.number, input.index,
                                                  drive::own_source(source.number, source.index), bus.now);
    check(written.has_value(), "source of what is sent");
  }

  static constexpr std::uint8_t kAxis = drive::kFirstAxisNumber;
  static constexpr std::size_t kWords = 20, kLast = kWords - 1;
  static constexpr std::uint16_t kCounted = 7, kControlByPlc = 0x0400;
  static constexpr std::uint16_t kStatusBits = 13;
  /// Speed, torque, current, power, a word that was received: behind a status word.
  static constexpr std::array<std::uint16_t, 5> kSources{63, 80, 82, 68, 2050};
  std::array<std::uint16_t, kWords> words = [] {
    std::array<std::uint16_t, kWords> all{kControlByPlc};
    all.back() = kCounted;
    return all;
  }();
};

struct RestingTick {
  RestingTick() {
    bus.enter_operational();
    bus.pass(std::chrono::seconds{1});
    check(bus.unit.next_deadline() == canopen::kNever, "a unit at rest");
  }
  void step() {
    bus.unit.on_time(bus.now);
    earliest = bus.unit.next_deadline();
  }

  DeviceUnit bus;
  canopen::TimePoint earliest{};
};

}  // namespace

std::vector<OperationRow> device_operations() {
  std::vector<OperationRow> rows{
      {"device/sdo_upload", "unit: SDO expedited upload, the same object", make<Upload>},
      {"device/sdo_upload_random", "unit: SDO expedited upload, random object", make<RandomUpload>},
      {"device/sdo_upload_slope", "unit: SDO expedited upload of 6083h, a parameter", make<SlopeUpload>},
      {"device/sdo_download", "unit: SDO expedited download of 60FFh", make<Download>},
      {"device/sdo_download_ramp", "unit: SDO expedited download of p1120", make<ParameterDownload>},
      {"device/rpdo", "unit: RPDO with 3 objects applied", make<Rpdo>},
      {"device/sync_4", "unit: SYNC to 4 TPDOs, 7 objects", make<Sync>},
      {"device/tick_turning", "unit: 4 ms tick, axis at speed, 4 event-driven TPDOs sent", make<TurningTick>},
      {"device/tick_exchanging", "unit: the same with 20 words each way on IF1", make<ExchangingTick>},
      {"device/tick_resting", "unit: tick with nothing due", make<RestingTick>},
  };
  const auto cycles = cycle_operations();
  rows.insert(rows.end(), cycles.begin(), cycles.end());
  return rows;
}

}  // namespace bench
