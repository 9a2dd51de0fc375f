#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "farm/agent/unit/unit_folder.hpp"
#include "farm/storage/object_store.hpp"

namespace farm::agent {

/// Jobs about what units have saved; they wait for the server and for the disk. Errors are one line.
class StateTransfer {
 public:
  /// Of the farm called @p farm.
  StateTransfer(std::string farm, Folders folders) : farm_{std::move(farm)}, folders_{std::move(folders)} {}

  /// Replaces what @p unit has saved here by what lies on the server, if there is anything. The checksum of that;
  /// nothing if there is nothing.
  [[nodiscard]] tl::expected<std::optional<std::uint32_t>, std::string> fetch(Storage& storage,
                                                                              const UnitName& unit) const;

  /// What upload() came to.
  struct Upload {
    bool is_others = false;                 ///< somebody else has taken the unit since, so nothing was written
    std::optional<std::uint32_t> checksum;  ///< of what lies on the server now
  };
  /// Puts what @p unit has saved here on the server, if its place is still that of @p term.
  [[nodiscard]] tl::expected<Upload, std::string> upload(Storage& storage, const UnitName& unit,
                                                         std::uint64_t term) const;

 private:
  std::string farm_;
  Folders folders_;
};

}  // namespace farm::agent
