#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/canopen-check/core/run/context.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {

/// A PDO that is valid.
struct ValidPdo {
  std::uint16_t parameters = 0;  ///< index of its communication parameters
  std::uint32_t identifier = 0;
};

/// The valid PDOs of 11-bit identifiers whose parameters begin at @p first, object::kRpdoParameter or
/// object::kTpdoParameter. Without an EDS the first four are looked at.
[[nodiscard]] std::vector<ValidPdo> valid_pdos(Context& context, std::uint16_t first);

/// The PDO among @p pdos that @p frame carries, or null.
[[nodiscard]] const ValidPdo* pdo_of(const std::vector<ValidPdo>& pdos, const canopen::Frame& frame) noexcept;

/// A frame for an RPDO that changes one value of the dictionary, and does no harm.
struct HarmlessRpdo {
  canopen::Frame frame{};
  std::uint16_t index = 0;  ///< the entry that it changes
  std::uint8_t sub_index = 0;
  std::uint64_t before = 0, after = 0;  ///< what the entry holds before and afterwards
};

/// True if the tester may write every object that @p rpdo is mapped to.
[[nodiscard]] bool harmless(Context& context, const ValidPdo& rpdo);

/// A frame for @p rpdo with the values that its objects have; nothing if it is not harmless.
[[nodiscard]] std::optional<canopen::Frame> unchanged(Context& context, const ValidPdo& rpdo);

/// An RPDO that has been seen to work in Operational, and is ready to be sent again; what it changes is restored
/// behind the check. Nothing, and the check is skipped, if there is none. The node is in Pre-operational then.
[[nodiscard]] std::optional<HarmlessRpdo> working_rpdo(Context& context);

/// A TPDO that has been seen to follow SYNC in Operational, with transmission type 1; nothing, and the check is
/// skipped, if there is none. The node is in Pre-operational then.
[[nodiscard]] std::optional<ValidPdo> synchronous_tpdo(Context& context);

/// True if a SYNC under @p identifier makes @p tpdo come.
[[nodiscard]] bool follows_sync(Context& context, const ValidPdo& tpdo, std::uint32_t identifier);

/// The identifier of SYNC, as 1005h says.
[[nodiscard]] std::uint32_t sync_identifier(Context& context);

}  // namespace conformance
