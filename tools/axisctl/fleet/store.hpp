#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "farm/documents/place.hpp"
#include "farm/documents/wanted_unit.hpp"
#include "farm/naming/unit_name.hpp"
#include "farm/storage/object_store.hpp"
#include "tools/axisctl/fleet/wanted_fleet.hpp"

/// What the server of a farm keeps of its fleet, and changes of it. All errors are one line.
namespace fleet {

template <class Result>
using Stored = tl::expected<Result, std::string>;

/// What became of something that was asked for.
enum class Effect : std::uint8_t { Created, Changed, Unchanged };
[[nodiscard]] std::string_view text_of(Effect effect) noexcept;

/// What became of units and buses, by their names, in the order of these.
struct Applied {
  std::vector<std::pair<std::string, Effect>> units;
  std::vector<std::pair<std::string, Effect>> buses;
};
/// Has what @p wanted asks for wanted in @p farm. What it does not name stays as it is.
[[nodiscard]] Stored<Applied> apply(farm::Storage& storage, const std::string& farm, const WantedFleet& wanted);

/// A unit as the server knows it.
struct KnownUnit {
  std::optional<farm::WantedUnit> wanted{};
  std::string wrong{};  ///< why `wanted` is missing though there is a document
  farm::Place place{};
};
[[nodiscard]] Stored<std::map<farm::UnitName, KnownUnit>> read(farm::Storage& storage, const std::string& farm);

/// Has @p units, and all units of @p buses, wanted no more; the names of those that were.
[[nodiscard]] Stored<std::vector<std::string>> remove(farm::Storage& storage, const std::string& farm,
                                                      const std::vector<farm::UnitName>& units,
                                                      const std::vector<std::string>& buses);
/// Has @p unit wanted on @p host alone. False: it is not wanted at all.
[[nodiscard]] Stored<bool> move(farm::Storage& storage, const std::string& farm, const farm::UnitName& unit,
                                const std::string& host);
/// Has the agent of @p host give its units away, or take some again.
[[nodiscard]] Stored<bool> drain(farm::Storage& storage, const std::string& farm, const std::string& host,
                                 bool drain);

}  // namespace fleet
