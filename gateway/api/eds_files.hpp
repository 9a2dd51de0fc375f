#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "gateway/server/exchange.hpp"
#include "gateway/units/daemons.hpp"

namespace gateway {

/// Of what kind a unit is, as far as its EDS depends on it.
struct UnitKind {
  std::string profile{};  ///< as `units` tells it: "s120", "cia402"
  std::size_t axes = 0;
};

/// The EDS of units, one for each profile and number of axes. A file is read when it is asked for the first time.
class EdsFiles {
 public:
  /// Those in @p folder.
  explicit EdsFiles(std::filesystem::path folder) : folder_{std::move(folder)} {}

  /// Answers @p exchange by the EDS of @p unit, which @p daemon has, switched on or off. It is kept until then.
  void answer(const std::shared_ptr<Exchange>& exchange, const std::string& unit, DaemonClient& daemon);

 private:
  [[nodiscard]] Response response_for(const UnitKind& kind);

  std::filesystem::path folder_;
  std::map<std::string, std::shared_ptr<const std::string>> texts_;  ///< by the name of the file
};

}  // namespace gateway
