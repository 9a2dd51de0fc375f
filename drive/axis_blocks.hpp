#pragma once

#include <tuple>

#include "drive/brake/holding_brake.hpp"
#include "drive/external_messages/external_messages.hpp"
#include "drive/identification/identification.hpp"
#include "drive/measurement/measurement.hpp"
#include "drive/motor_model/motor_model.hpp"
#include "drive/motor_monitoring/motor_monitoring.hpp"
#include "drive/power_unit/power_unit.hpp"
#include "drive/references.hpp"
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

}  // namespace drive
