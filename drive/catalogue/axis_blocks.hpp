#pragma once

#include <tuple>

#include "drive/base/references.hpp"
#include "drive/brake/holding_brake.hpp"
#include "drive/external_messages/external_messages.hpp"
#include "drive/identification/identification.hpp"
#include "drive/jog/jog.hpp"
#include "drive/measurement/encoder_interface.hpp"
#include "drive/measurement/measurement.hpp"
#include "drive/motor_model/motor_model.hpp"
#include "drive/motor_monitoring/motor_monitoring.hpp"
#include "drive/operator_panel/operator_panel.hpp"
#include "drive/parameter/block.hpp"
#include "drive/positioning/actual_position/actual_position.hpp"
#include "drive/positioning/control/position_control.hpp"
#include "drive/positioning/positioner/positioner.hpp"
#include "drive/power_unit/power_unit.hpp"
#include "drive/sequence_control/sequence_control.hpp"
#include "drive/sequence_control/statusword.hpp"
#include "drive/setpoint_channel/setpoint_channel.hpp"
#include "drive/speed_control/speed_control.hpp"
#include "drive/speed_messages/speed_messages.hpp"
#include "drive/torque/torque_setpoint.hpp"

namespace drive {

/// The function blocks of an axis. Parameters, wiring and causes of messages follow from this list; its turn in a
/// cycle a block has in the table of axis_schedule.cpp.
using AxisBlocks = std::tuple<OperatorPanel,     //
                              SequenceControl,   //
                              ExternalMessages,  //
                              SpeedControl,      //
                              Jog,               //
                              SetpointChannel,   //
                              SpeedSetpoint2,    //
                              TorqueSetpoint,    //
                              HoldingBrake,      //
                              ActualPosition,    //
                              Positioner,        //
                              PositionControl,   //
                              Identification,    //
                              MotorModel,        //
                              PowerUnit,         //
                              Measurement,       //
                              EncoderInterface,  //
                              SpeedMessages,     //
                              MotorMonitoring,   //
                              FreeStatusBits,    //
                              ReferenceValues>;

/// Whether @p Block has inputs that wiring brings.
template <class Block>
inline constexpr bool kHasInputs = requires {
  typename Block::Inputs;
};

}  // namespace drive
