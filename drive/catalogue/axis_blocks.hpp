#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "drive/base/references.hpp"
#include "drive/brake/holding_brake.hpp"
#include "drive/external_messages/external_messages.hpp"
#include "drive/identification/identification.hpp"
#include "drive/measurement/measurement.hpp"
#include "drive/motor_model/motor_model.hpp"
#include "drive/motor_monitoring/motor_monitoring.hpp"
#include "drive/parameter/block.hpp"
#include "drive/power_unit/power_unit.hpp"
#include "drive/sequence_control/sequence_control.hpp"
#include "drive/sequence_control/statusword.hpp"
#include "drive/setpoint_channel/setpoint_channel.hpp"
#include "drive/speed_control/speed_control.hpp"
#include "drive/speed_messages/speed_messages.hpp"
#include "drive/torque/torque_setpoint.hpp"

namespace drive {

/// The function blocks of an axis. Parameters, wiring and causes of messages follow from this list; its turn in a
/// cycle a block has in axis_schedule.cpp.
using AxisBlocks = std::tuple<SequenceControl,   //
                              ExternalMessages,  //
                              SpeedControl,      //
                              SetpointChannel,   //
                              TorqueSetpoint,    //
                              HoldingBrake,      //
                              Identification,    //
                              MotorModel,        //
                              PowerUnit,         //
                              Measurement,       //
                              SpeedMessages,     //
                              MotorMonitoring,   //
                              FreeStatusBits,    //
                              ReferenceValues>;

/// Whether the inputs of @p Block are taken when a cycle begins (in the order of the list), or when it is over,
/// which a block says with a member kInputsAtTheEnd.
template <class Block, bool AtTheEnd>
inline constexpr bool kTakesInputs = [] {
  if constexpr (requires { typename Block::Inputs; }) return requires {
      Block::kInputsAtTheEnd;
    }
  == AtTheEnd;
  else return false;
}();

template <bool AtTheEnd, class... Block>
constexpr auto blocks_with_inputs(const std::tuple<Block...>*) noexcept {
  std::array<BlockId, (std::size_t{kTakesInputs<Block, AtTheEnd>} + ...)> ids{};
  std::size_t count = 0;
  const auto add = [&](BlockId id, bool takes) {
    if (takes) ids[count++] = id;
  };
  (add(kBlock<Block>, kTakesInputs<Block, AtTheEnd>), ...);
  return ids;
}
inline constexpr auto kInputsAtTheBeginning = blocks_with_inputs<false>(static_cast<const AxisBlocks*>(nullptr));
inline constexpr auto kInputsAtTheEnd = blocks_with_inputs<true>(static_cast<const AxisBlocks*>(nullptr));

}  // namespace drive
