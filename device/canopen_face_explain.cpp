// Why an axis does not turn.
#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "device/canopen_face.hpp"
#include "device/objects/object_index.hpp"
#include "device/pdo/pdo_objects.hpp"
#include "drive/explain/explain.hpp"
#include "drive/parameter/bico.hpp"
#include "libcanopen/base/cob_id.hpp"

namespace device {
namespace {

constexpr std::uint16_t kPlaces = 4;              // of words whose bits can be connected, r8890 to r8893
constexpr std::uint16_t kFirstCobId = 8700;       // p8700 to p8707, [0]
constexpr std::uint16_t kFirstMapping = 8710;     // p8710 to p8717
constexpr std::uint16_t kReceivedObjects = 8750;  // r8750
constexpr std::uint16_t kReceivedBits = 8890;     // r8890 to r8893
constexpr std::uint16_t kUnmappedControlword = 8795;
constexpr std::uint16_t kOnSource = 840;

/// The axis and the unit as they are between two cycles.
struct Picture {
  const drive::DriveUnit& unit;
  const canopen::Node& node;
  std::size_t number;

  const drive::Axis& axis() const noexcept { return unit.axes()[number - 1]; }
  /// 6040h of the axis.
  std::uint32_t controlword_index() const noexcept { return object::on_axis(object::kControlword, number); }
  std::uint32_t parameter(std::uint16_t parameter, std::size_t index) const noexcept {
    return unit.read(axis().number(), parameter, index)
        .map(drive::decode)
        .map([](double value) { return static_cast<std::uint32_t>(value); })
        .value_or(0);
  }
};
using P = const Picture&;

/// How far 6040h gets: whether an RPDO maps it, and whether a valid one does.
struct Way {
  bool mapped = false;
  bool valid = false;
};
Way way_of_the_controlword(P p) {
  Way way{};
  for (std::uint16_t rpdo = 0; rpdo < pdo::kOfAnAxis; ++rpdo)
    for (std::uint16_t entry = 0; entry < pdo::kMostEntries; ++entry) {
      const std::uint32_t mapped = p.parameter(static_cast<std::uint16_t>(kFirstMapping + rpdo), entry);
      if (mapped >> 16 != p.controlword_index()) continue;
      way.mapped = true;
      way.valid |=
          (p.parameter(static_cast<std::uint16_t>(kFirstCobId + rpdo), 0) & canopen::cob_id::kInvalid) == 0;
    }
  return way;
}

/// Whether p0840 follows bit 0 of the controlword.
bool is_on_connected(P p) {
  const drive::BicoSource source = drive::unpack(p.parameter(kOnSource, 0));
  const bool own = source.object == drive::kOwnObject || source.object == p.axis().number();
  if (!own || source.position != 0) return false;
  if (source.number == kUnmappedControlword) return true;
  if (source.number < kReceivedBits || source.number >= kReceivedBits + kPlaces) return false;
  return p.parameter(kReceivedObjects, source.number - kReceivedBits) == p.controlword_index();
}

bool is_operational(P p) noexcept {
  return p.node.state() == canopen::NmtState::Operational;
}
/// Whether the axis is commanded by controlwords that no RPDO can have brought.
bool is_led_over_sdo(P p) {
  return p.axis().controlword() != 0 && !way_of_the_controlword(p).valid;
}

struct Reason {
  bool (*holds)(P);
  std::string (*text)(P);
};
constexpr std::array kReasons{
    Reason{[](P p) { return !is_operational(p) && !is_led_over_sdo(p); },
           [](P p) {
             return fmt::format("The node is {}, so that no PDO is received: send the NMT command start (01h).",
                                canopen::name_of(p.node.state()));
           }},
    Reason{[](P p) { return !way_of_the_controlword(p).mapped && !is_led_over_sdo(p); },
           [](P p) {
             return fmt::format("No RPDO maps the controlword {:04X}h: map it, or write it over SDO.",
                                p.controlword_index());
           }},
    Reason{[](P p) {
             const Way way = way_of_the_controlword(p);
             return way.mapped && !way.valid && !is_led_over_sdo(p);
           },
           [](P p) {
             return fmt::format(
                 "The RPDO of the controlword {:04X}h is not valid: write its COB-ID with bit 31 = 0.",
                 p.controlword_index());
           }},
    Reason{[](P p) { return !is_on_connected(p); },
           [](P) -> std::string {
             return "ON (p0840) is not connected to bit 0 of the controlword: write p8790 = 1, or command its "
                    "source.";
           }},
    Reason{[](P p) { return is_operational(p) && p.axis().controlword() == 0; },
           [](P) -> std::string {
             return "The controlword is 0000h, as if none had been received yet: send 0006h, then 000Fh.";
           }},
};

}  // namespace

std::vector<std::string> CanopenFace::explain(std::size_t number, std::vector<std::string> commanding) const {
  const drive::DriveUnit& unit = runner_.unit();
  const Picture picture{unit, node_, number};
  std::vector<std::string> bus = std::move(commanding);
  const bool by_hand = picture.axis().block<drive::OperatorPanel>().is_active();
  if (by_hand) bus.clear();
  const bool is_led_by_the_bus = bus.empty() && !by_hand;
  for (const Reason& reason : kReasons)
    if (is_led_by_the_bus && reason.holds(picture)) bus.push_back(reason.text(picture));
  if (const drive::Infeed* const infeed = unit.infeed())
    for (std::string& sentence : drive::explain(*infeed)) bus.push_back(std::move(sentence));
  return drive::explain(picture.axis(), bus);
}

AxisView CanopenFace::view(std::size_t number) const noexcept {
  const drive::Axis& axis = runner_.unit().axes()[number - 1];
  return {.state = axis.actual().state,
          .controlword = axis.process_data().controlword,
          .statusword = axis.actual().statusword,
          .position = axis.actual().encoder_position};
}

}  // namespace device
