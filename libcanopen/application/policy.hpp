#pragma once

#include <array>
#include <span>

#include "libcanopen/base/nmt_state.hpp"
#include "libcanopen/base/time.hpp"

namespace canopen {

/// Answer to an NMT command specifier that CiA 301 does not define.
enum class UnknownCommand : std::uint8_t { Ignore, Stop };

/// Heartbeat producer (1017h) and node guarding (100Ch, 100Dh) must not work at once (CiA 301, 7.2.8.3.2).
enum class ErrorControlConflict : std::uint8_t {
  Refuse,         ///< a write that would switch on the second one is refused with InvalidValue
  HeartbeatWins,  ///< while 1017h is not 0 the node answers no guarding request and watches no life time
};

/// Who keeps the error register 1001h and the error history 1003h and sends EMCY for communication errors.
enum class ErrorKeeping : std::uint8_t {
  Library,  ///< Node::raise_error() and Node::clear_error(), and every CommunicationError by itself
  Owner,    ///< the application, with its own layout of 1003h, through Node::send_emcy()
};

/// What happens first at a SYNC.
enum class SyncOrder : std::uint8_t {
  TransmitFirst,  ///< TPDOs show what was before the SYNC; then each synchronous RPDO is stored and told
  ReceiveFirst,   ///< all synchronous RPDOs are stored, then each is told, then
                  ///< Application::on_synchronous_rpdos(); TPDOs show what has become of it
};

/// Transmission types from `first` to `last`.
struct TypeRange {
  std::uint8_t first, last;
};
/// Every transmission type of an RPDO (CiA 301, table "RPDO transmission types").
inline constexpr std::array kRpdoTypes{TypeRange{0, 240}, TypeRange{254, 255}};
/// Every transmission type of a TPDO (CiA 301, table "TPDO transmission types").
inline constexpr std::array kTpdoTypes{TypeRange{0, 240}, TypeRange{252, 255}};

/// What CiA 301 leaves to the device, decided once for a node.
struct Policy {
  NmtState start_state = NmtState::PreOperational;  ///< entered after every boot-up
  UnknownCommand unknown_command = UnknownCommand::Ignore;
  ErrorControlConflict error_control_conflict = ErrorControlConflict::HeartbeatWins;
  ErrorKeeping error_keeping = ErrorKeeping::Library;
  bool remote_frames = true;  ///< false: the bus carries none, so a write that would switch on life guarding is
                              ///< refused with DeviceState, and stored values do not switch it on
  bool extended_identifiers = true;  ///< false: a COB-ID with the frame bit is refused with InvalidValue

  bool sdo_block = true;                    ///< false: block transfer is refused with CommandSpecifierInvalid
  bool predefined_sdo_identifiers = false;  ///< true: servers beyond the first may listen to 601h..67Fh and answer
                                            ///< under 581h..5FFh, those of their own node-ID excepted
  Duration sdo_timeout = std::chrono::seconds{10};  ///< above 0: silence that aborts a half-finished transfer

  SyncOrder sync_order = SyncOrder::TransmitFirst;
  bool sync_of_any_length = false;  ///< true: a SYNC of a wrong length (1019h) is reported and counts all the same
  bool sync_supervision = false;  ///< true: in Operational, from the first SYNC on, a silence of one and a half of
                                  ///< 1006h is CommunicationError::SyncTimeout until the next SYNC

  bool pdo_changes_in_operational = true;  ///< false: PDO parameters are refused with DeviceState in Operational
  bool count_follows_entries = false;  ///< true: sub-index 0 of a mapping counts its entries; when 0 was written
                                       ///< to it and nothing since, it does so when the PDO becomes valid
  bool tpdo_requests = true;           ///< false: no remote frame is answered by a TPDO, whatever its COB-ID says
  std::uint8_t dummy_types = 0xFE;     ///< bit n: the dummy object 000nh (n 1..7) may be mapped into RPDOs
  std::span<const TypeRange> rpdo_types = kRpdoTypes;  ///< others are refused with InvalidValue
  std::span<const TypeRange> tpdo_types = kTpdoTypes;  ///< likewise
};

}  // namespace canopen
