#include "device/pdo/pdo_rules.hpp"

#include <algorithm>
#include <array>

#include "device/pdo/predefined_connections.hpp"
#include "libcanopen/base/cob_id.hpp"

namespace device {
namespace {

using canopen::AbortCode;
using canopen::MappingCount;
using canopen::Result;
using pdo::Direction;
using pdo::Part;
using pdo::Pdo;

// Alarms of the PDO configuration.
constexpr std::uint16_t kWrongState = 8754;
constexpr std::uint16_t kNotMappable = 8755;
constexpr std::uint16_t kTooManyBytes = 8756;
constexpr std::uint16_t kCobIdValid = 8757;
constexpr std::uint16_t kTooManyPdos = 8758;
constexpr std::uint16_t kCobIdInUse = 8759;
constexpr std::uint16_t kTooManyWords = 8760;

/// The value that tells more of an alarm.
enum class Detail : std::uint8_t {
  None,
  Direction,  ///< 1 RPDO, 2 TPDO
  Parameter,  ///< the number of the PDO's parameter
};

/// Which alarm a refusal raises.
struct AlarmRow {
  AbortCode code;
  Part part;
  bool operational;
  std::uint16_t alarm;
  Detail detail;
};
constexpr std::array kAlarms{
    AlarmRow{AbortCode::DeviceState, Part::Communication, true, kWrongState, Detail::None},
    AlarmRow{AbortCode::DeviceState, Part::Mapping, true, kWrongState, Detail::None},
    AlarmRow{AbortCode::DeviceState, Part::Communication, false, kCobIdValid, Detail::None},
    AlarmRow{AbortCode::DeviceState, Part::Mapping, false, kCobIdValid, Detail::None},
    AlarmRow{AbortCode::NotMappable, Part::Communication, false, kNotMappable, Detail::None},
    AlarmRow{AbortCode::NotMappable, Part::Mapping, false, kNotMappable, Detail::None},
    AlarmRow{AbortCode::PdoLengthExceeded, Part::Communication, false, kTooManyBytes, Detail::None},
    AlarmRow{AbortCode::PdoLengthExceeded, Part::Mapping, false, kTooManyBytes, Detail::None},
    AlarmRow{AbortCode::InternalIncompatibility, Part::Communication, false, kTooManyPdos, Detail::Direction},
    AlarmRow{AbortCode::InternalIncompatibility, Part::Mapping, false, kTooManyWords, Detail::Direction},
    AlarmRow{AbortCode::ParameterIncompatible, Part::Communication, false, kCobIdInUse, Detail::Parameter},
};

std::uint32_t detail_of(Detail detail, Pdo pdo) noexcept {
  constexpr std::uint32_t kReceiveParameter = 8700, kTransmitParameter = 8720;
  const bool receives = pdo.direction == Direction::Receive;
  switch (detail) {
    case Detail::Direction:
      return receives ? 1 : 2;
    case Detail::Parameter:
      return (receives ? kReceiveParameter : kTransmitParameter) + pdo.place();
    case Detail::None:
      break;
  }
  return 0;
}

/// Calls @p visit for every PDO of @p direction on axes 1 to @p axes, in the order of their numbers.
template <class Visit>
void for_each_pdo(Direction direction, std::size_t axes, const Visit& visit) {
  for (std::size_t axis = 1; axis <= axes; ++axis)
    for (std::uint16_t place = 0; place < pdo::kOfAnAxis; ++place) visit(pdo::of_axis(direction, axis, place));
}

constexpr std::array kDirections{Direction::Receive, Direction::Transmit};

/// Entries before the first empty one.
std::uint8_t leading_entries(const pdo::Mapping& mapping) noexcept {
  const auto* const empty = std::ranges::find(mapping.entries, 0U);
  return static_cast<std::uint8_t>(empty - mapping.entries.begin());
}

}  // namespace

PdoRules::PdoRules(canopen::Dictionary& dictionary, drive::DriveUnit& unit, const canopen::Node& node,
                   const Listeners& listeners)
    : dictionary_{dictionary}, unit_{unit}, node_{node}, listeners_{listeners} {
  for (const canopen::Entry& entry : dictionary.entries())
    if (pdo::record_of(entry.index) && entry.writable) dictionary.own_write(entry.index, entry.sub_index, *this);
}

std::size_t PdoRules::most(Direction direction) const noexcept {
  if (direction == Direction::Receive) return kMostReceivePdos;
  constexpr std::uint16_t kCycle = 8848;  // ms
  constexpr std::size_t kLeast = 8;
  constexpr double kMicroseconds = 1000.0;
  const double cycle = unit_.object(drive::kControlUnitNumber)->read(kCycle).value_or(0.0) * kMicroseconds;
  const double sampling = shortest_sampling_time();
  return sampling > 0.0 ? std::max(kLeast, static_cast<std::size_t>(cycle / sampling)) : kLeast;
}

/// p0115[0] of the axis that has the shortest (µs), 0 if none has one.
double PdoRules::shortest_sampling_time() const noexcept {
  constexpr std::uint16_t kSamplingTimes = 115;
  double shortest = 0.0;
  for (const drive::Axis& axis : unit_.axes()) {
    const double time = axis.read(kSamplingTimes).value_or(0.0);
    if (time > 0.0 && (time < shortest || !(shortest > 0.0))) shortest = time;
  }
  return shortest;
}

std::size_t PdoRules::remaining(Direction direction) const noexcept {
  std::size_t valid = 0;
  for_each_pdo(direction, unit_.axes().size(), [&](Pdo pdo) { valid += identifier_of(pdo) != 0 ? 1U : 0U; });
  const std::size_t all = most(direction);
  return valid < all ? all - valid : 0;
}

/// 0 while the PDO is not valid.
canopen::Identifier PdoRules::identifier_of(Pdo pdo) const noexcept {
  const auto cob_id = dictionary_.stored(pdo::index_of(pdo, Part::Communication), canopen::pdo_sub::kCobId);
  return cob_id ? canopen::valid_identifier(static_cast<std::uint32_t>(*cob_id)) : 0;
}

void PdoRules::limit() noexcept {
  for (const Direction direction : kDirections) {
    std::size_t valid = 0;
    bool exceeded = false;
    for_each_pdo(direction, unit_.axes().size(), [&](Pdo pdo) {
      if (identifier_of(pdo) == 0) return;
      const bool fits = valid < most(direction);
      exceeded = exceeded || !fits;
      if (fits && judge_whole(pdo, pdo::mapping_of(dictionary_, pdo))) return static_cast<void>(++valid);
      const canopen::Entry* const entry =
          dictionary_.lookup(pdo::index_of(pdo, Part::Communication), canopen::pdo_sub::kCobId);
      dictionary_.set(*entry, dictionary_.stored(*entry) | canopen::cob_id::kInvalid);
    });
    if (exceeded) raise(kTooManyPdos, detail_of(Detail::Direction, {direction, 0}));
  }
}

Result<void> PdoRules::take_over(std::size_t axis) noexcept {
  constexpr std::uint16_t kConfiguration = 8744;
  constexpr double kPredefined = 1.0;
  if (unit_.axes()[axis - 1].read(kConfiguration).value_or(0.0) > kPredefined) return {};
  return restore_predefined_connections(dictionary_, axis);
}

/// The alarm for a refusal; one of a time or a type has none but in Operational.
void PdoRules::raise_for(AbortCode code, const pdo::Record& record) noexcept {
  const bool operational = is_operational();
  const auto* const row = std::ranges::find_if(kAlarms, [&](const AlarmRow& r) {
    return r.code == code && r.part == record.part && r.operational == operational;
  });
  if (row != kAlarms.end()) raise(row->alarm, detail_of(row->detail, record.pdo));
}

void PdoRules::raise(std::uint16_t number, std::uint32_t value) noexcept {
  listeners_.alarm.on_alarm();
  static_cast<void>(unit_.raise(drive::kControlUnitNumber, number, value, drive::Cause::Latched));
}

void PdoRules::end_alarms() noexcept {
  for (std::uint16_t number = kWrongState; number <= kTooManyWords; ++number) end_alarm(number);
}

void PdoRules::end_alarm(std::uint16_t number) noexcept {
  const auto alarms = unit_.object(drive::kControlUnitNumber)->messages().alarms();
  const auto is_it = [=](const drive::FaultEntry& alarm) { return alarm.row->number == number; };
  if (std::ranges::none_of(alarms, is_it)) return;
  listeners_.alarm.on_alarm();
  unit_.withdraw(drive::kControlUnitNumber, number);
}

Result<void> PdoRules::write(const canopen::Entry& entry, std::int64_t value) {
  const pdo::Record record = *pdo::record_of(entry.index);
  auto judged = judge(record, entry.sub_index, static_cast<std::uint32_t>(value));
  if (!judged) {
    raise_for(judged.error(), record);
  } else if (record.part == Part::Mapping) {
    end_alarm(kNotMappable);
    end_alarm(kTooManyBytes);
    listeners_.mapping.on_mapping_changed(record.pdo.axis());
  } else if (entry.sub_index == canopen::pdo_sub::kCobId) {
    end_alarms();
    if (mapping_count(record.pdo) == MappingCount::Awaited)
      listeners_.mapping.on_mapping_changed(record.pdo.axis());
  }
  return judged;
}

Result<void> PdoRules::judge(const pdo::Record& record, std::uint8_t sub_index,
                             std::uint32_t value) const noexcept {
  if (is_operational()) return canopen::refuse(AbortCode::DeviceState);
  if (record.part == Part::Mapping) return judge_mapping(record.pdo, sub_index, value);
  return sub_index == canopen::pdo_sub::kCobId ? judge_cob_id(record.pdo, value) : Result<void>{};
}

Result<void> PdoRules::judge_cob_id(Pdo pdo, std::uint32_t cob_id) const noexcept {
  const canopen::Identifier wanted = canopen::valid_identifier(cob_id);
  const canopen::Identifier present = identifier_of(pdo);
  if ((cob_id & canopen::cob_id::kInvalid) != 0) return {};
  if (!canopen::is_assignable(cob_id, false)) return canopen::refuse(AbortCode::InvalidValue);
  if (present != 0) return wanted == present ? Result<void>{} : canopen::refuse(AbortCode::DeviceState);
  if (node_.uses(wanted)) return canopen::refuse(AbortCode::ParameterIncompatible);
  if (remaining(pdo.direction) == 0) return canopen::refuse(AbortCode::InternalIncompatibility);
  pdo::Mapping mapping = pdo::mapping_of(dictionary_, pdo);
  if (mapping_count(pdo) == MappingCount::Awaited) mapping.count = leading_entries(mapping);
  return judge_whole(pdo, mapping);
}

Result<void> PdoRules::judge_mapping(Pdo pdo, std::uint8_t sub_index, std::uint32_t value) const noexcept {
  if (identifier_of(pdo) != 0) return canopen::refuse(AbortCode::DeviceState);
  if (value == 0) return {};
  pdo::Mapping mapping = pdo::mapping_of(dictionary_, pdo);
  if (sub_index == 0) {
    mapping.count = static_cast<std::uint8_t>(value);
    return judge_whole(pdo, mapping);
  }
  if (pdo::mapped_object(dictionary_, pdo, value) == nullptr) return canopen::refuse(AbortCode::NotMappable);
  mapping.entries[sub_index - 1U] = value;
  if (mapping_count(pdo) == MappingCount::Follows) mapping.count = leading_entries(mapping);
  return judge_whole(pdo, mapping);
}

/// What sub-index 0 of the mapping does with its entries.
MappingCount PdoRules::mapping_count(Pdo pdo) const noexcept {
  const auto pdos = pdo.direction == Direction::Receive ? node_.receive_pdos() : node_.transmit_pdos();
  const auto found = std::ranges::find(pdos, pdo.number, &canopen::PdoSettings::number);
  return found != pdos.end() ? found->mapping_count : MappingCount::Zero;
}

Result<void> PdoRules::judge_whole(Pdo pdo, const pdo::Mapping& mapping) const noexcept {
  constexpr unsigned kMostBits = 64;
  unsigned bits = 0;
  for (std::uint8_t i = 0; i < mapping.count; ++i) {
    const canopen::Entry* const object = pdo::mapped_object(dictionary_, pdo, mapping.entries[i]);
    if (object == nullptr) return canopen::refuse(AbortCode::NotMappable);
    bits += object->bits;
  }
  if (bits > kMostBits) return canopen::refuse(AbortCode::PdoLengthExceeded);
  const PendingMapping pending{pdo, mapping};
  const bool fits = ProcessDataLayout{}.compute(dictionary_, pdo.direction, pdo.axis(), &pending);
  return fits ? Result<void>{} : canopen::refuse(AbortCode::InternalIncompatibility);
}

}  // namespace device
