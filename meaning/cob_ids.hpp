#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <map>
#include <unordered_map>

#include "eds/description/description.hpp"
#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/base/frame.hpp"
#include "meaning/sdo_watch.hpp"

namespace meaning {

/// What a frame is for (CiA 301).
enum class Role : std::uint8_t {
  Unknown,
  Nmt,
  Sync,
  Time,
  Emergency,
  Tpdo,
  Rpdo,
  SdoResponse,
  SdoRequest,
  ErrorControl,  ///< heartbeat, boot-up message, answer of node guarding
  Guarding,      ///< the remote frame that asks for it
  LssRequest,
  LssResponse,
};

/// Whose frame it is, and which of several.
struct Meaning {
  Role role = Role::Unknown;
  std::uint8_t node = 0;     ///< 0: of no one
  std::uint16_t number = 0;  ///< of a PDO, or of an SDO server, from 1

  // NOLINTNEXTLINE(modernize-use-nullptr): it takes the comparison with 0 for one with a pointer
  friend constexpr auto operator<=>(const Meaning&, const Meaning&) = default;
};

/// The identifier that TPDO @p number of @p node has by the predefined connection set; 0: none.
[[nodiscard]] canopen::Identifier predefined_tpdo(std::uint8_t node, std::uint16_t number) noexcept;

/// Which identifier means what: that of the predefined connection set (CiA 301, 7.3.3), what an EDS says, and what
/// was written since.
class CobIds {
 public:
  CobIds() = default;
  /// With the COB-IDs that @p description states for the node that it was read for.
  explicit CobIds(const eds::Description& description) { describe(description); }
  /// Takes those of one more node.
  void describe(const eds::Description& description);

  /// What @p frame means.
  [[nodiscard]] Meaning meaning_of(const canopen::Frame& frame) const noexcept;
  /// Whether RPDOs of several nodes, or of one, have the identifier of @p frame.
  [[nodiscard]] bool is_shared(const canopen::Frame& frame) const noexcept;
  /// Follows @p frame, which means @p meaning: COB-IDs that are written, saved, and lost with a reset. The value
  /// of an entry that it tells.
  std::optional<EntryValue> follow(const canopen::Frame& frame, const Meaning& meaning);

 private:
  struct Given {
    std::map<Meaning, canopen::Identifier> identifiers{};  ///< 0: none
    friend bool operator==(const Given&, const Given&) = default;
  };
  void learn(const EntryValue& entry);
  void give(const Meaning& service, canopen::Identifier identifier);
  void reset(std::uint8_t node);
  /// @p to has what @p from has of @p node; 0: of all.
  static void copy(const Given& from, Given& to, std::uint8_t node);
  void index();
  void take_in(const Meaning& service, canopen::Identifier identifier);

  Given given_{}, saved_{}, described_{};
  /// What an identifier means.
  struct Service {
    Meaning meaning{};
    bool is_shared = false;  ///< by several RPDOs
  };
  std::unordered_map<canopen::Identifier, Service> services_;  ///< those of given_
  SdoWatch sdo_{};
};

}  // namespace meaning
