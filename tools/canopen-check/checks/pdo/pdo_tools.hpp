#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "libcanopen/od/abort_code.hpp"
#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// Which way a PDO goes, as seen from the node.
enum class PdoDirection : std::uint8_t { Receive, Transmit };

// Sub-indices of the communication parameters.
inline constexpr std::uint8_t kCobIdSub = 1, kTypeSub = 2, kInhibitSub = 3, kReservedSub = 4, kTimerSub = 5,
                              kSyncStartSub = 6;

/// A PDO of the node.
struct Pdo {
  PdoDirection direction = PdoDirection::Receive;
  std::uint16_t number = 0;  ///< 0 is the first

  [[nodiscard]] std::uint16_t parameters() const noexcept;
  [[nodiscard]] std::uint16_t mapping() const noexcept;
  /// "RPDO 1".
  [[nodiscard]] std::string name() const;
};

/// An object as a mapping names it.
struct MappedObject {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::uint8_t bits = 0;

  [[nodiscard]] static MappedObject of(std::uint32_t entry) noexcept;
  [[nodiscard]] std::uint32_t entry() const noexcept;
  [[nodiscard]] std::size_t bytes() const noexcept { return bits / 8U; }
};

/// What a check wants of a PDO; what is not given stays.
struct PdoSetup {
  std::optional<std::uint8_t> type{};
  std::optional<std::uint16_t> inhibit_time{};  ///< 100 us; where the node has it
  std::optional<std::uint16_t> event_timer{};   ///< ms; where the node has it
  std::optional<std::uint8_t> sync_start{};
  std::vector<MappedObject> mapping{};
  bool remote_requests = false;  ///< bit 30 is clear
};

/// Every PDO of the EDS; without one those of the first four that the node has.
[[nodiscard]] std::vector<Pdo> all_pdos(Context& context, PdoDirection direction);
/// The PDO that checks reconfigure: the last valid one, else the first that maps something, else the first.
/// Without any the check is skipped.
[[nodiscard]] std::optional<Pdo> test_pdo(Context& context, PdoDirection direction);
/// test_pdo() of both directions; skipped only without any.
[[nodiscard]] std::vector<Pdo> test_pdos(Context& context);
/// The COB-ID of @p pdo without bits 29 to 31, or that of the predefined connection set where it is none.
[[nodiscard]] std::uint32_t identifier_of(Context& context, const Pdo& pdo);
/// What the node says that @p pdo maps.
[[nodiscard]] std::vector<MappedObject> mapping_of(Context& context, const Pdo& pdo);
/// True if the node, or the EDS, has this parameter of @p pdo.
[[nodiscard]] bool has_parameter(Context& context, const Pdo& pdo, std::uint8_t sub_index);

/// True if @p answer refuses to make @p pdo valid, and that maps nothing: a device may do so. It is noted.
bool refused_as_empty(Context& context, const Pdo& pdo, const SdoAnswer& answer);
/// Makes @p pdo invalid; false, and the check is skipped, where that is refused.
bool disable(Context& context, const Pdo& pdo);
/// Gives @p pdo @p setup by the procedure of CiA 301 7.5.2.36 and makes it valid. False, and the check is skipped,
/// where that is refused: other checks say what may not be refused.
bool set_up(Context& context, const Pdo& pdo, const PdoSetup& setup);
/// Maps @p objects into @p pdo, which is invalid: the answer to the first request that is refused, or to the last.
SdoAnswer map_objects(Context& context, const Pdo& pdo, const std::vector<MappedObject>& objects);

/// Objects that a TPDO can carry, of 8, 16 or 32 bits, those that change least first.
[[nodiscard]] std::vector<MappedObject> transmittable(Context& context);
/// Objects that an RPDO can carry and that the tester may write, likewise.
[[nodiscard]] std::vector<MappedObject> receivable(Context& context);
/// The object that changes least as the mapping of a TPDO; nothing, which leaves the mapping, where none is known
/// or the mapping is fixed.
[[nodiscard]] std::vector<MappedObject> calm_mapping(Context& context, const Pdo& pdo);
/// An object that an SDO can write and a TPDO can carry; else the check is skipped.
[[nodiscard]] std::optional<MappedObject> changeable(Context& context);
/// Writes another value to @p object, one that its limits allow: what was written.
std::uint64_t change(Context& context, const MappedObject& object);
/// A value of @p object other than the present one, within its limits.
[[nodiscard]] std::uint64_t other_value(Context& context, const MappedObject& object);
/// Frames of the node under @p identifier in the traffic from @p mark on.
[[nodiscard]] std::vector<TimedFrame> frames_since(Context& context, std::size_t mark, std::uint32_t identifier);
/// The bytes of @p frame as a number.
[[nodiscard]] std::uint64_t number_in(const canopen::Frame& frame) noexcept;

/// The SYNC messages of the tester, with a counter where 1019h asks for it.
class SyncSource {
 public:
  explicit SyncSource(Context& context);

  void send();
  /// Sends a SYNC: the first frame under @p identifier within @p patience.
  [[nodiscard]] std::optional<TimedFrame> next(std::uint32_t identifier, canopen::Duration patience);
  /// Sends @p count SYNCs, @p period apart: every frame under @p identifier, until one period after the last.
  [[nodiscard]] std::vector<TimedFrame> run(int count, canopen::Duration period, std::uint32_t identifier);
  /// The same, but how many frames came with each SYNC; the first one may take @p patience.
  [[nodiscard]] std::vector<std::size_t> count_each(int count, canopen::Duration period, std::uint32_t identifier,
                                                    canopen::Duration patience = {});

 private:
  Session* session_;
  std::uint32_t identifier_ = 0x80;
  std::uint8_t overflow_ = 0, counter_ = 0;
};

}  // namespace conformance
