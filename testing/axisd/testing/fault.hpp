#pragma once

#include <functional>
#include <string>

#include "axisd/testing/control.hpp"

namespace axisd::testing {

/// A fault that was injected (docs/reference/faults.md); it stays until it is over or removed.
class Fault {
 public:
  /// Calls a method of who has the fault: a unit, or the hub of its bus.
  using Call = std::function<nlohmann::json(const std::string& method, const nlohmann::json& params)>;

  Fault(Call call, int identifier) : call_{std::move(call)}, identifier_{identifier} {}
  /// Its row of `inject.list`: state, hits, opportunities, hit_at. Error if it was removed.
  [[nodiscard]] nlohmann::json row() const {
    const nlohmann::json faults = call_("inject.list", nlohmann::json::object());
    for (const nlohmann::json& row : faults.at("faults"))
      if (row.at("id") == identifier_) return row;
    throw Error{"fault " + std::to_string(identifier_) + " is no longer there"};
  }
  /// How often it has struck.
  [[nodiscard]] int hits() const { return row().at("hits"); }
  /// waiting, active or over.
  [[nodiscard]] std::string state() const { return row().at("state"); }
  /// Takes it back.
  void remove() { call_("inject.remove", {{"id", identifier_}}); }

 private:
  Call call_;
  int identifier_;
};

}  // namespace axisd::testing
