#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "drive/parameter/row.hpp"

namespace unit {

/// The parts of the saved parameters that can be saved, restored and reset by themselves.
enum class ParameterGroup : std::uint8_t {
  All = 1,
  Communication = 2,  ///< how the unit takes part in its field bus
  Application = 3,    ///< what the drive profile of its field bus shows
};

/// Which of the saved parameters belong to which group: the face of the field bus says that of all but All.
class ParameterGroups {
 public:
  /// The members of @p group, which is not All, are those that @p members names.
  void define(ParameterGroup group, drive::RowFilter members) noexcept { members_[index_of(group)] = members; }

  /// The saved parameters that @p group has.
  drive::RowFilter saved(ParameterGroup group) const noexcept {
    return group == ParameterGroup::All ? drive::RowFilter{drive::is_saved} : members_[index_of(group)];
  }
  /// Those of them that a reset changes.
  drive::RowFilter reset(ParameterGroup group) const noexcept {
    return group == ParameterGroup::All ? drive::RowFilter{drive::is_reset} : members_[index_of(group)];
  }
  /// Whether @p row belongs to @p group; every one belongs to All, saved or not.
  bool contains(ParameterGroup group, const drive::ParameterRow& row) const noexcept {
    return group == ParameterGroup::All || members_[index_of(group)](row);
  }

 private:
  static bool none(const drive::ParameterRow&) noexcept { return false; }
  static constexpr std::size_t index_of(ParameterGroup group) noexcept {
    return static_cast<std::size_t>(group) - static_cast<std::size_t>(ParameterGroup::Communication);
  }

  std::array<drive::RowFilter, 2> members_{none, none};
};

}  // namespace unit
