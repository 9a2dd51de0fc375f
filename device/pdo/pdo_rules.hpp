#pragma once

#include <cstdint>

#include "device/pdo/pdo_objects.hpp"
#include "device/pdo/process_data_layout.hpp"
#include "drive/drive_unit.hpp"
#include "libcanopen/node/node.hpp"
#include "libcanopen/pdo/settings.hpp"

namespace device {

/// Who knows where mapped objects lie.
class MappingListener {
 public:
  virtual ~MappingListener() = default;
  /// A mapping of @p axis (from 1) is about to change.
  virtual void on_mapping_changed(std::size_t axis) noexcept = 0;
};

/// Who shows alarms.
class AlarmListener {
 public:
  virtual ~AlarmListener() = default;
  /// An alarm of the unit is about to come or to go.
  virtual void on_alarm() noexcept = 0;
};

/// The rules of the unit for PDO parameters beyond those of CiA 301: how many PDOs may be valid, which objects an
/// axis may map, and the room in its process data. Whatever the reason, a refusal raises an alarm, A08754 to
/// A08760, which stays until a COB-ID is written with success, the NMT state changes or p2111 = 0.
class PdoRules final : public canopen::EntryOwner {
 public:
  /// Who is told.
  struct Listeners {
    MappingListener& mapping;
    AlarmListener& alarm;
  };
  /// Most valid RPDOs of the unit.
  static constexpr std::size_t kMostReceivePdos = 25;

  /// Owns the PDO records in @p dictionary; all arguments must outlive this.
  PdoRules(canopen::Dictionary& dictionary, drive::DriveUnit& unit, const canopen::Node& node,
           const Listeners& listeners);

  /// Valid PDOs that the unit can have in @p direction: 25, or p8848 over the shortest p0115[0], at least 8.
  std::size_t most(pdo::Direction direction) const noexcept;
  /// r8742: valid PDOs that the unit can still have.
  std::size_t remaining(pdo::Direction direction) const noexcept;

  /// Makes PDOs beyond the number that may be valid invalid (bit 31), in the order of their numbers; for values
  /// that no master has written.
  void limit() noexcept;
  /// p8741 = 1 for @p axis (from 1): with p8744 = 1 its PDOs become those of the predefined connection set again,
  /// with p8744 = 2 they stay as they are. DeviceState in Operational, or why a PDO could not become valid.
  canopen::Result<void> take_over(std::size_t axis) noexcept;

  /// The NMT state has changed: the alarms end.
  void end_alarms() noexcept;

  /// DeviceState, InvalidValue (identifier), ParameterIncompatible (identifier in use), NotMappable,
  /// PdoLengthExceeded, InternalIncompatibility (number of PDOs, room in the process data).
  canopen::Result<void> write(const canopen::Entry& entry, std::int64_t value) override;

 private:
  canopen::Result<void> judge(const pdo::Record& record, std::uint8_t sub_index,
                              std::uint32_t value) const noexcept;
  canopen::Result<void> judge_cob_id(pdo::Pdo pdo, std::uint32_t cob_id) const noexcept;
  canopen::Result<void> judge_mapping(pdo::Pdo pdo, std::uint8_t sub_index, std::uint32_t value) const noexcept;
  canopen::Result<void> judge_whole(pdo::Pdo pdo, const pdo::Mapping& mapping) const noexcept;
  void raise_for(canopen::AbortCode code, const pdo::Record& record) noexcept;
  void raise(std::uint16_t number, std::uint32_t value) noexcept;
  canopen::Identifier identifier_of(pdo::Pdo pdo) const noexcept;
  canopen::MappingCount mapping_count(pdo::Pdo pdo) const noexcept;
  bool is_operational() const noexcept { return node_.state() == canopen::NmtState::Operational; }
  double shortest_sampling_time() const noexcept;
  void end_alarm(std::uint16_t number) noexcept;

  canopen::Dictionary& dictionary_;
  drive::DriveUnit& unit_;
  const canopen::Node& node_;
  Listeners listeners_;
};

}  // namespace device
