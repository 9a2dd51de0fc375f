#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

namespace gateway {

/// What a unit has told of itself, or that it did not answer.
struct UnitSample {
  std::string unit;                  ///< its name, "vcan0/5"
  nlohmann::json status = nullptr;   ///< result of the control method `status`; null: no answer
  nlohmann::json metrics = nullptr;  ///< result of `metrics`
  std::string host{};                ///< of a farm: where it is; else empty
};

/// Media type of what exposition() gives.
inline constexpr const char* kExpositionType = "text/plain; version=0.0.4; charset=utf-8";

/// @p units in the text format of Prometheus 0.0.4; docs/reference/metrics.md describes each family. A member that
/// a daemon of another version does not have is left out.
std::string exposition(std::span<const UnitSample> units);

}  // namespace gateway
