#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/canopen-check/core/run/context.hpp"
#include "tools/canopen-check/core/run/entry_values.hpp"

namespace conformance {

/// The values of everything that may be written on the node, to be put back at the end of a run: resets bring
/// stored values back, and what was not stored would be lost.
class Snapshot {
 public:
  /// Reads every entry that the EDS calls writable, each by itself, as long as the session lasts.
  Snapshot(SdoClient& sdo, const eds::Description& eds, const Settings& settings);

  /// Writes back what has changed, PDO parameters by their procedure; a line for each entry that does not hold its
  /// value then.
  [[nodiscard]] std::vector<std::string> restore();
  [[nodiscard]] std::size_t size() const noexcept { return values_.size(); }

 private:
  using Bytes = std::vector<std::uint8_t>;

  [[nodiscard]] std::vector<Entry> changed();
  void restore_pdo(std::uint16_t parameters);
  void write_back(std::uint16_t index, std::uint8_t sub_index);

  SdoClient* sdo_;
  EntryValues values_;
};

}  // namespace conformance
