#pragma once

#include <deque>

#include "device/pdo/pdo_rules.hpp"
#include "device/process_data/process_data_buffers.hpp"
#include "device/process_data/standard_wiring.hpp"
#include "unit/parameter_owner.hpp"
#include "unit/unit_parameters.hpp"

namespace device {

/// Answers for the parameters of the PDO configuration and of the process data: p8741, r8742, p8790 and
/// what ProcessDataBuffers shows.
class ProcessDataParameters final : public unit::ParameterOwner {
 public:
  /// Answers in @p parameters; @p buffers and @p wiring have one for each axis, in their order. All arguments must
  /// outlive this.
  ProcessDataParameters(const std::deque<ProcessDataBuffers>& buffers, std::deque<StandardWiring>& wiring,
                        PdoRules& rules, unit::UnitParameters& parameters);

  std::optional<double> value_of(const unit::ParameterPlace& place) const noexcept override;
  /// p8741 = 1 takes p8744 over, with what PdoRules::take_over() refuses. p8790 = 1: NotNow unless 6040h is mapped
  /// to one of the first four words.
  std::optional<drive::Refusal> take(const unit::ParameterPlace& place, double value) noexcept override;

 private:
  std::optional<drive::Refusal> connect_controlword(std::size_t module) noexcept;

  const std::deque<ProcessDataBuffers>& buffers_;
  std::deque<StandardWiring>& wiring_;
  PdoRules& rules_;
};

}  // namespace device
