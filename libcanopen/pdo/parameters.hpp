#pragma once

#include <array>
#include <span>
#include <vector>

#include "libcanopen/base/export.hpp"
#include "libcanopen/node/context.hpp"
#include "libcanopen/pdo/mapping.hpp"

namespace canopen {

/// Sub-indices of a PDO communication record (CiA 301, 7.5.2.35 and 7.5.2.37).
namespace pdo_sub {
inline constexpr std::uint8_t kCobId = 1;
inline constexpr std::uint8_t kTransmissionType = 2;
inline constexpr std::uint8_t kInhibitTime = 3;
inline constexpr std::uint8_t kEventTimer = 5;
inline constexpr std::uint8_t kSyncStart = 6;
}  // namespace pdo_sub

/// Highest synchronous transmission type (CiA 301, tables "RPDO transmission types", "TPDO transmission types").
inline constexpr std::uint8_t kLastSynchronousType = 0xF0;

/// Whether sub-index 0 of a mapping counts the entries by itself (Policy::count_follows_entries).
enum class MappingCount : std::uint8_t {
  Follows,  ///< with every entry that is written
  Zero,     ///< 0 was written to it: entries do not count before it is written again (CiA 301, 7.5.2.36)
  Awaited,  ///< as Zero, but entries were written since: they count when the PDO becomes valid
};

/// What is in force of one PDO.
struct PdoSettings {
  Identifier identifier = 0;  ///< 0 while the PDO is not valid
  std::uint16_t number = 0;   ///< 0 for 1400h or 1800h
  std::uint8_t transmission_type = 0;
  bool remote_allowed = false;  ///< TPDO: remote frames are answered
  MappingCount mapping_count = MappingCount::Follows;
  MappingPlan plan{};

  bool is_valid() const noexcept { return identifier != 0; }
  /// Valid and with something mapped; a PDO without mapping is disabled (CiA 301, 7.5.2.36).
  bool is_active() const noexcept { return is_valid() && plan.length() != 0; }
  /// A TPDO that remote frames may ask for (bit 30 of its COB-ID).
  bool is_requestable() const noexcept { return is_active() && remote_allowed; }
};

/// Communication and mapping parameters of all PDOs of one direction, with the rules for changing them
/// (CiA 301, 7.5.2.35 to 7.5.2.38).
class CANOPEN_EXPORT PdoParameters final : public EntryOwner {
 public:
  /// The service that works with the PDOs.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// Identifier, type or mapping of the PDO at @p position changed.
    virtual void on_pdo_changed(std::size_t position) noexcept = 0;
    /// A time of the PDO at @p position was set: @p sub_index of its communication record to @p value.
    virtual void on_pdo_time_changed(std::size_t position, std::uint8_t sub_index,
                                     std::int64_t value) noexcept = 0;
  };

  /// Finds the PDO records in the dictionary of @p context and owns their writes.
  PdoParameters(Context& context, Direction direction);
  /// How many PDOs of @p direction @p dictionary has.
  static std::size_t count_in(const Dictionary& dictionary, Direction direction) noexcept;
  /// Who is told of changes; set once, before the first frame.
  void listen(Listener& listener) noexcept { listener_ = &listener; }

  /// Starts over with the values in the dictionary; no PDO is valid before claim_identifiers().
  void reload() noexcept;
  /// Makes the PDOs valid that are so in the dictionary. One that cannot be, because of its mapping or because its
  /// identifier is in use or not allowed, gets bit 31 of its COB-ID set: a master sees it. To be called when all
  /// other services have their identifiers.
  void claim_identifiers() noexcept;
  /// All PDOs that the dictionary has, in the order of their numbers.
  std::span<const PdoSettings> pdos() const noexcept { return pdos_; }
  /// The stored value of @p sub_index in the communication record of @p pdo, 0 if there is none.
  std::int64_t communication(const PdoSettings& pdo, std::uint8_t sub_index) const noexcept;

  Result<void> write(const Entry& entry, std::int64_t value) override;

 private:
  Result<void> write_communication(std::size_t position, std::uint8_t sub_index, std::int64_t value);
  Result<void> write_cob_id(std::size_t position, std::uint32_t cob_id);
  Result<void> write_remote_bit(PdoSettings& pdo, std::uint32_t cob_id);
  Result<void> write_type(std::size_t position, std::uint8_t type);
  Result<void> write_count(PdoSettings& pdo, std::uint8_t count);
  Result<void> write_mapping(PdoSettings& pdo, std::uint8_t sub_index, std::uint32_t mapped);
  Result<void> follow_entries(const PdoSettings& pdo, std::uint8_t sub_index, std::uint32_t mapped);
  std::uint8_t leading_entries(const PdoSettings& pdo) const noexcept;
  void set_count(const PdoSettings& pdo, std::uint8_t count) noexcept;
  void own(std::uint16_t index);
  void give_room();
  void changed(std::size_t position) noexcept;
  bool claim(PdoSettings& pdo, std::uint32_t cob_id) noexcept;
  bool allows_remote(std::uint32_t cob_id) const noexcept;
  MappingRules rules() const noexcept;
  std::uint8_t count(const PdoSettings& pdo) const noexcept;
  std::uint16_t mapping_index(const PdoSettings& pdo) const noexcept;

  Context& context_;
  Direction direction_;
  Listener* listener_ = nullptr;
  std::uint16_t communication_base_;
  std::uint16_t mapping_base_;
  std::vector<PdoSettings> pdos_;
  std::vector<MappedValue> values_;  ///< where the plans of all PDOs lie, in their order
  std::array<std::uint16_t, 512> position_{};
};

}  // namespace canopen
