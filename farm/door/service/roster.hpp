#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "farm/documents/door_beat.hpp"

namespace farm {

/// A unit that is reached at the door.
struct Reached {
  DoorUnit unit;          ///< as the farm sees it
  std::string name;       ///< as its daemon calls it: "vcan0/5"
  std::string interface;  ///< its bus, as the daemon was told

  friend bool operator==(const Reached&, const Reached&) = default;
};

/// The units that the daemons of the machine have told.
class Roster {
 public:
  /// The daemon at @p path has answered @p result to `units`. Whether that is news.
  bool take(const std::string& path, const nlohmann::json& result);
  /// Daemons at @p paths are there, and no others. Whether units have gone by it.
  bool keep(const std::set<std::string>& paths);

  /// Whether the daemon at @p path has answered.
  [[nodiscard]] bool knows(const std::string& path) const { return told_.contains(path); }

  /// By their names in the farm. Of two that would be called the same the one of the first path counts.
  [[nodiscard]] const std::map<UnitName, Reached>& units() const noexcept { return units_; }
  /// nullptr: it is not reached here.
  [[nodiscard]] const Reached* find(const UnitName& unit) const noexcept;
  /// The name in the farm of the unit that its daemon calls @p name; nullptr: it is not reached here.
  [[nodiscard]] const UnitName* name_in_farm(std::string_view name) const noexcept;

 private:
  void put_together();

  std::map<std::string, std::vector<Reached>> told_;  ///< by the paths of the daemons
  std::map<UnitName, Reached> units_;
  std::map<std::string, UnitName, std::less<>> names_;
};

}  // namespace farm
