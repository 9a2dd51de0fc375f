#pragma once

#include <optional>

#include <nlohmann/json.hpp>

#include "daemon/control/parameters/interconnections.hpp"
#include "daemon/control/parameters/parameter_name.hpp"
#include "daemon/instance/instance.hpp"
#include "drive/images/saved_values.hpp"

namespace axisd {

/// What a parameter is compared with.
enum class Reference : std::uint8_t {
  Factory,  ///< the value of a new unit
  Stored    ///< what was saved last; of a drive object that was not saved the value of a new one
};

/// The parameters of one unit as the control socket shows them, for the time of one request.
class ParameterView {
 public:
  /// @p instance outlives this.
  explicit ParameterView(const Instance& instance);

  /// What @p row is, on whatever drive object.
  static nlohmann::json definition(const drive::ParameterRow& row);
  /// Everything about index @p index of @p placed of @p object, which provides it.
  nlohmann::json entry(const drive::DriveObject& object, const drive::PlacedRow& placed, std::size_t index) const;
  /// Where it is and what it reads as, with that of @p reference.
  nlohmann::json difference(const drive::DriveObject& object, const drive::PlacedRow& placed, std::size_t index,
                            Reference reference) const;
  /// Whether a saved parameter has another value than @p reference has; false of one that is not saved.
  bool differs(const drive::DriveObject& object, const drive::PlacedRow& placed, std::size_t index,
               Reference reference) const noexcept;

 private:
  drive::ParameterValue present(const drive::DriveObject& object, const drive::PlacedRow& placed,
                                std::size_t index) const noexcept;
  drive::ParameterValue reference_value(const drive::DriveObject& object, const drive::ParameterRow& row,
                                        std::size_t index, Reference reference) const noexcept;
  void add_access(nlohmann::json& entry, const drive::DriveObject& object, const drive::ParameterRow& row) const;
  void add_references(nlohmann::json& entry, const drive::DriveObject& object, const drive::PlacedRow& placed,
                      std::size_t index) const;
  void add_source(nlohmann::json& entry, const drive::DriveObject& object, const drive::ParameterRow& row,
                  std::uint32_t packed) const;
  void add_uses(nlohmann::json& entry, const drive::DriveObject& object, const drive::ParameterRow& row) const;

  const Instance& instance_;
  const drive::DriveUnit& unit_;
  drive::SavedValues saved_;
  Interconnections interconnections_;
};

}  // namespace axisd
