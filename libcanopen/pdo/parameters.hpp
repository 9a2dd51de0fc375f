#pragma once

#include <array>
#include <span>
#include <vector>

#include "libcanopen/pdo/settings.hpp"
#include "libcanopen/service/context.hpp"
#include "libcanopen/service/identifier_list.hpp"

namespace canopen {

/// Communication and mapping parameters of all PDOs of one direction, with the rules for changing them
/// (CiA 301, 7.5.2.35 to 7.5.2.38).
class PdoParameters final : public EntryOwner {
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
