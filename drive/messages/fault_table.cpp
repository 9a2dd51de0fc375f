#include "drive/messages/fault_table.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace drive {
namespace {

// What p2100 and p2101 can make of a reaction.
constexpr Reactions kFixed = 0;
constexpr Reactions kNone = bit_of(Reaction::None);
constexpr Reactions kOff1 = bit_of(Reaction::Off1);
constexpr Reactions kOff2 = bit_of(Reaction::Off2);
constexpr Reactions kOff3 = bit_of(Reaction::Off3);
constexpr Reactions kStop2 = bit_of(Reaction::Stop2);
constexpr Reactions kShortCircuit = bit_of(Reaction::ShortCircuit);
constexpr Reactions kEncoder = bit_of(Reaction::Encoder);

// clang-format off
constexpr std::array kRows{
    FaultRow{1000, Kind::Fault, Scope::ControlUnit, Reaction::Off2, kFixed, Acknowledge::PowerOn, Propagation::Local, 0x1000, 0x81, "Internal software error", "internal error, unit must be restarted"},
    FaultRow{1002, Kind::Fault, Scope::ControlUnit, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Internal software error", "internal error, acknowledgeable"},
    FaultRow{1097, Kind::Alarm, Scope::ControlUnit, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "NTP server unreachable", "no answer for 10 minutes; never here, as the clock of the host counts as the answer"},
    FaultRow{1099, Kind::Alarm, Scope::ControlUnit, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "UTC synchronisation tolerance violated", "the clock was corrected by more than p3109; r3107 and r3108 show it; gone with the next correction inside the tolerance"},
    FaultRow{1505, Kind::Fault, Scope::Both, Reaction::None, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "BICO telegram cannot be wired", "an input that the telegram of p0922 or p2079 holds cannot be connected"},
    FaultRow{1906, Kind::Alarm, Scope::ControlUnit, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EtherNet/IP configuration faulty", "EtherNet/IP is served by a program of its own, if at all"},
    FaultRow{1910, Kind::Fault, Scope::Axis, Reaction::Off3, kNone | kOff1 | kOff2 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Fieldbus interface setpoint timeout", "no process data on IF1 for p2040, p2047 and p2044"},
    FaultRow{1912, Kind::Fault, Scope::Axis, Reaction::Off1, kNone | kOff2 | kOff3 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "PROFIdrive sign of life failed", "more than p0925 wrong values of the sign of life in STW2 in a row"},
    FaultRow{1920, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Fieldbus interface setpoint interruption", "no process data on IF1 for p2040 and p2047; gone when they come again"},
    FaultRow{1925, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Modbus TCP connection interrupted", "a connection was closed that had written process data; gone when they come again"},
    FaultRow{1980, Kind::Alarm, Scope::ControlUnit, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "PROFINET no cyclic connection", "PROFINET is not served"},
    FaultRow{7011, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1 | kOff3 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Motor overtemperature", "sensor or model above p0605, or p0604 exceeded longer than p0606"},
    FaultRow{7012, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Motor temperature model 1/3 overtemperature", "thermal model above its alarm threshold"},
    FaultRow{7015, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Motor temperature sensor alarm", "sensor wire break or short circuit"},
    FaultRow{7016, Kind::Fault, Scope::Axis, Reaction::Off1, kNone | kOff2 | kOff3 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Motor temperature sensor fault", "temperature sensor wire break or short circuit detected"},
    FaultRow{7085, Kind::Fault, Scope::Axis, Reaction::None, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Control parameters changed", "firmware corrected control parameters to fit limits"},
    FaultRow{7090, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Upper torque limit below lower limit", "p1520 effective value is smaller than p1521 effective value"},
    FaultRow{7200, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Master control ON command present", "ON not at 0 when control priority was taken over"},
    FaultRow{7220, Kind::Fault, Scope::Axis, Reaction::Off1, kNone | kOff2 | kOff3 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Control by PLC missing", "signal at p0854 dropped while running"},
    FaultRow{7300, Kind::Fault, Scope::Axis, Reaction::Off2, kNone, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Line contactor feedback missing", "feedback not seen after p0861"},
    FaultRow{7400, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Vdc max controller active", "DC link near upper limit, torque is reduced"},
    FaultRow{7403, Kind::Fault, Scope::Axis, Reaction::Off1, kNone | kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Lower DC link threshold reached", "Vdc under p1248 with monitoring active"},
    FaultRow{7404, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Upper DC link threshold reached", "Vdc over p1244 with monitoring active"},
    FaultRow{7410, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Current controller output limited", "current setpoint not reached, motor not connected or Vdc missing"},
    FaultRow{7412, Kind::Fault, Scope::Axis, Reaction::Encoder, kNone | kOff2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Commutation angle incorrect", "motor model and encoder angle disagree, risk of positive feedback"},
    FaultRow{7430, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Changeover to torque control not possible", "torque mode requested while running encoderless"},
    FaultRow{7440, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS jerk time limited", "max(p2572;p2573)/p2574 above 1000 ms, 1000 ms is used; also shown while jerk limiting is off; gone when the quotient fits"},
    FaultRow{7441, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Save absolute encoder adjustment", "p2525 was changed by an adjustment and not yet saved; gone after save"},
    FaultRow{7442, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS multiturn and modulo range do not match", "multiturn range of an absolute encoder is not a whole multiple of p2576 (with position tracking off)"},
    FaultRow{7443, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Reference coordinate out of range", "absolute encoder adjustment or referencing with p2598 outside the representable range; fault value = largest permitted coordinate"},
    FaultRow{7446, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Load gear position tracking cannot be reset", "reset requested while not permitted"},
    FaultRow{7447, Kind::Fault, Scope::Axis, Reaction::None, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Load gear position tracking, maximum actual value exceeded", "range of the tracked position exceeded; fault value = maximum"},
    FaultRow{7448, Kind::Fault, Scope::Axis, Reaction::Off1, kNone | kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Load gear position tracking, linear axis exceeded range", "a linear axis has left the range that position tracking follows"},
    FaultRow{7449, Kind::Fault, Scope::Axis, Reaction::Off1, kNone | kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Load gear position tracking, actual position outside tolerance window", "difference r2724 larger than p2722 after power-up"},
    FaultRow{7450, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Standstill monitoring responded", "p2543 after setpoint standstill the deviation is larger than p2542 (checked cyclically from then on)"},
    FaultRow{7451, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Position monitoring responded", "p2545 after setpoint standstill the deviation is larger than p2544 (checked once)"},
    FaultRow{7452, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Following error too high", "|r2563| larger than p2546 while position control is active and travel to fixed stop is not"},
    FaultRow{7453, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Position actual value preprocessing error", "encoder in use is faulty or parked; position invalid, reference lost"},
    FaultRow{7454, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Position preprocessing has no valid encoder", "p2502 = 0 or points to no encoder of the data set; position invalid"},
    FaultRow{7455, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS maximum velocity limited", "p2571 cannot be used: more than half the modulo range per EPOS cycle, or beyond the number range; effective value limited"},
    FaultRow{7456, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS setpoint velocity limited", "commanded velocity times override above the effective maximum; r2683.1 = 1"},
    FaultRow{7457, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS illegal combination of input signals", "value: 0 jog 1 and jog 2; 1 jog and MDI; 2 jog and referencing; 3 jog and block start; 4 MDI and referencing; 5 MDI and block start; 6 referencing and block start"},
    FaultRow{7458, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS reference cam not found", "p2606 travelled from the start of the search without p2612 = 1"},
    FaultRow{7459, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS zero mark not found", "p2609 travelled after leaving the cam (or from the start without cam) without a mark in the window"},
    FaultRow{7460, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS end of reference cam not found", "end of the number range reached during step 2 while still on the cam"},
    FaultRow{7461, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS reference point not set", "block started, or absolute MDI commanded, while r2684.11 = 0: the task is not started"},
    FaultRow{7462, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS selected block number does not exist", "number from p2625..p2630 missing in p2616 or its block hidden; value = block number; nothing starts"},
    FaultRow{7463, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS external block change not requested", "block with CONTINUE_EXTERNAL_ALARM reached its target without the signal; value = block number; block interrupted"},
    FaultRow{7464, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS traversing block inconsistent", "started block holds invalid data (see A07465..A07472 for the reason); value = block number"},
    FaultRow{7465, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS traversing block has no subsequent block", "continuation condition other than END and no block follows; value = block number"},
    FaultRow{7466, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS block number assigned more than once", "value = block number"},
    FaultRow{7467, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS illegal task parameter", "p2622 not valid for the task; value = block number"},
    FaultRow{7468, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS jump destination does not exist", "GOTO to a missing or hidden block; value = block number"},
    FaultRow{7469, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS block target below software limit minus", "absolute target < limit; value = block number"},
    FaultRow{7470, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS block target above software limit plus", "absolute target > limit; value = block number"},
    FaultRow{7471, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS block target outside the modulo range", "absolute target not within 0 .. p2576-1; value = block number"},
    FaultRow{7472, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS block ABS_POS or ABS_NEG not possible", "direction mode without modulo correction; value = block number"},
    FaultRow{7473, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS beginning of traversing range reached", "setpoint at -2147482648 LU moving negative"},
    FaultRow{7474, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS end of traversing range reached", "setpoint at 2147482647 LU moving positive"},
    FaultRow{7475, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS target position below start of range", "relative target below -2147482648 LU"},
    FaultRow{7476, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS target position above end of range", "relative target above 2147482647 LU"},
    FaultRow{7477, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS target position below software limit minus", "relative or MDI target < limit; travel ends at the limit"},
    FaultRow{7478, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS target position above software limit plus", "relative or MDI target > limit; travel ends at the limit"},
    FaultRow{7479, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS software limit minus reached", "setpoint stands at the limit; r2683.6 = 1; gone when moved away"},
    FaultRow{7480, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS software limit plus reached", "setpoint stands at the limit; r2683.7 = 1; gone when moved away"},
    FaultRow{7481, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS axis position below software limit minus", "actual position < limit and setpoint not moving back"},
    FaultRow{7482, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS axis position above software limit plus", "actual position > limit and setpoint not moving back"},
    FaultRow{7483, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS clamping torque not reached", "fixed stop detected, torque below p2622 (limit p1520/p1521 or current limit lower)"},
    FaultRow{7484, Kind::Fault, Scope::Axis, Reaction::Off3, kOff1 | kOff2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS fixed stop outside monitoring window", "actual position left +/- p2635 around the stop position while clamped"},
    FaultRow{7485, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS fixed stop not reached", "braking point of the block target reached without fixed stop"},
    FaultRow{7486, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS intermediate stop missing", "start of block or MDI with p2640 = 0: not started"},
    FaultRow{7487, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS reject task missing", "start of block or MDI with p2641 = 0: not started"},
    FaultRow{7488, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS relative positioning not possible", "MDI continuous transfer (p2649 = 1) together with relative"},
    FaultRow{7489, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS reference point correction outside window", "flying referencing difference above p2602; no correction; r2684.3 = 1"},
    FaultRow{7490, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS enable withdrawn while traversing", "p2656 lost during a task (fault, OFF1/OFF2/OFF3, other missing enable) or start of a task without it"},
    FaultRow{7491, Kind::Fault, Scope::Axis, Reaction::Off3, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS STOP cam minus reached", "p2569 = 0 while p2568 = 1; only positive travel permitted until left"},
    FaultRow{7492, Kind::Fault, Scope::Axis, Reaction::Off3, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS STOP cam plus reached", "p2570 = 0 while p2568 = 1; only negative travel permitted until left"},
    FaultRow{7493, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Overflow of the position actual value range", "value: 1 r2521 beyond -2147483648..2147483647; 2 encoder value Gn_XIST2; 3 maximum encoder value times gear; reference lost"},
    FaultRow{7494, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Drive data set changeover in operation", "encoder, gear or direction differ between the data sets while in operation (p2519)"},
    FaultRow{7495, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Reference function interrupted", "search, flying referencing or probe evaluation ended by encoder fault, parking, withdrawn request or a setting of the actual value"},
    FaultRow{7496, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS enable not possible", "task started without enable; value: 1 p2656 = 0; 2 p2658 = 0"},
    FaultRow{7497, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Position setting value activated", "p2514 = 1 sets the actual value"},
    FaultRow{7498, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Measuring probe evaluation not possible", "value: 6 probe terminal not parameterised; 4098 probe could not be started; 4100 probe not possible; > 50000 measuring cycle not permitted"},
    FaultRow{7499, Kind::Fault, Scope::Axis, Reaction::Off3, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS reversing cam approached with the incorrect direction", "p2613 = 0 while moving positive or p2614 = 0 while moving negative during the search"},
    FaultRow{7503, Kind::Fault, Scope::Axis, Reaction::None, kOff1 | kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "EPOS STOP cam approached with the incorrect direction", "p2569 = 0 reached while moving positive or p2570 = 0 while moving negative (STOP cams active)"},
    FaultRow{7505, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EPOS fixed stop not possible", "task FIXED STOP in V/f or encoderless control; value = block number; block not executed"},
    FaultRow{7557, Kind::Alarm, Scope::Axis, Reaction::None, kOff1, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Reference point coordinate not in the permitted range", "p2598 outside the traversing or modulo range"},
    FaultRow{7575, Kind::Fault, Scope::Axis, Reaction::Off2, kEncoder, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Motor encoder not ready", "encoder signals not ready"},
    FaultRow{7577, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Encoder 1: measuring probe evaluation not possible", "value as A07498"},
    FaultRow{7581, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Encoder 1: position actual value preprocessing error", "encoder data unusable"},
    FaultRow{7584, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Encoder 1: position setting value activated", "p2514[1] = 1"},
    FaultRow{7587, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Encoder 1: position preprocessing has no valid encoder", "p2502 or data set without encoder"},
    FaultRow{7590, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Encoder 1: drive data set changeover in operation", "as F07494"},
    FaultRow{7593, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Encoder 1: position range exceeded", "value 1..3 as F07493"},
    FaultRow{7596, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Encoder 1: reference function interrupted", "as A07495"},
    FaultRow{7599, Kind::Fault, Scope::Axis, Reaction::Off1, kNone | kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Encoder 1: adjustment not possible", "adjustment would exceed the number range"},
    FaultRow{7800, Kind::Fault, Scope::Axis, Reaction::None, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "No power unit present", "power unit data unreadable"},
    FaultRow{7801, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Motor overcurrent", "permissible motor limit current exceeded"},
    FaultRow{7802, Kind::Fault, Scope::Axis, Reaction::Off2, kNone, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Infeed or power unit not ready", "no ready signal within p0857 after ON, Vdc missing"},
    FaultRow{7805, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Power unit overload I2t", "r0036 above p0294"},
    FaultRow{7840, Kind::Fault, Scope::Axis, Reaction::Off2, kNone, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Infeed operation missing", "p0864 missing although ON is present"},
    FaultRow{7841, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Infeed operation withdrawn", "p0864 dropped while running"},
    FaultRow{7850, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "External alarm 1", "0 at p2112"},
    FaultRow{7860, Kind::Fault, Scope::Both, Reaction::Off2, kShortCircuit | kNone | kOff1 | kOff3 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "External fault 1", "0 at p2106"},
    FaultRow{7861, Kind::Fault, Scope::Both, Reaction::Off2, kShortCircuit | kNone | kOff1 | kOff3 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "External fault 2", "0 at p2107"},
    FaultRow{7862, Kind::Fault, Scope::Both, Reaction::Off2, kShortCircuit | kNone | kOff1 | kOff3 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "External fault 3", "condition p2108/p3111/p3112 met"},
    FaultRow{7900, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1 | kOff3 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Motor blocked", "at torque limit and below p2175 for longer than p2177"},
    FaultRow{7901, Kind::Fault, Scope::Axis, Reaction::Off2, kShortCircuit, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Motor overspeed", "speed above min(p1082,p1085)+p2162 or below the negative counterpart"},
    FaultRow{7902, Kind::Fault, Scope::Axis, Reaction::Off2, kShortCircuit | kNone | kOff1 | kOff3 | kStop2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Motor stalled", "stall detected for longer than p2178"},
    FaultRow{7903, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Motor speed deviation", "setpoint and actual differ outside tolerance"},
    FaultRow{7910, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Motor overtemperature", "sensor above p0604"},
    FaultRow{7930, Kind::Fault, Scope::Axis, Reaction::Off1, kNone | kOff2 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Brake control error", "brake output wiring fault"},
    FaultRow{7950, Kind::Fault, Scope::Axis, Reaction::None, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Incorrect motor parameter", "motor data implausible during calculation, value = parameter number"},
    FaultRow{7980, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Rotating measurement activated", "p1960 set, motor may run up to maximum speed at next ON"},
    FaultRow{7985, Kind::Fault, Scope::Axis, Reaction::Off1, kNone | kOff2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Speed controller optimisation oscillation test", "rotating measurement failed"},
    FaultRow{7990, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Motor data identification incorrect", "p1910 measurement failed, value = step"},
    FaultRow{7991, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Motor data identification activated", "p1910 set, executed at next ON"},
    FaultRow{7994, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Motor data identification not performed", "vector control without identified motor"},
    FaultRow{8501, Kind::Fault, Scope::Axis, Reaction::Off3, kNone | kOff1 | kOff2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "COMM BOARD setpoint timeout", "no process data on a communication board for p8840; the CANopen board does not raise it"},
    FaultRow{8526, Kind::Alarm, Scope::ControlUnit, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "COMM BOARD no cyclic connection", "a communication board for PROFINET, which the unit does not have"},
    FaultRow{8550, Kind::Alarm, Scope::ControlUnit, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "PZD interface hardware assignment faulty", "p8839 as of power-on; IF1 or IF2, or both, count as not assigned"},
    FaultRow{8555, Kind::Alarm, Scope::ControlUnit, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Modbus TCP configuration faulty", "value: 1 two Modbus ports, 2 p0978[0] is no servo or vector axis"},
    FaultRow{8700, Kind::Fault, Scope::Both, Reaction::Off3, kNone | kOff1 | kOff2, Acknowledge::Immediately, Propagation::Global, 0x1001, 0x11, "CAN communication error", "value 1: transmit error counter passed 255 (bus-off); value 2: master did not poll within guard time x life time factor. Reaction taken from p8641. Present on CU too without reaction. After bus-off restart with p8608"},
    FaultRow{8701, Kind::Fault, Scope::Both, Reaction::Off3, kFixed, Acknowledge::Immediately, Propagation::Global, 0x1001, 0x11, "CAN NMT state change", "value 1: operational -> pre-operational; value 2: operational -> stopped. Reaction fixed (not from p8641). Just acknowledge; infeed OFF2"},
    FaultRow{8702, Kind::Fault, Scope::Both, Reaction::Off3, kNone | kOff1 | kOff2, Acknowledge::Immediately, Propagation::Global, 0x1001, 0x11, "CAN RPDO timeout", "no process data received within p8699 (0 = off)"},
    FaultRow{8703, Kind::Fault, Scope::Both, Reaction::Off3, kNone | kOff1 | kOff2, Acknowledge::Immediately, Propagation::Global, 0x1001, 0x11, "CAN too many drive objects", "more than 8 drive objects carry the CAN function module (p0108.29)"},
    FaultRow{8751, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Global, 0x8110, 0x11, "CAN telegram loss", "controller lost a received frame (frames closer than twice the CAN sampling time p8848); value 0 before FW 5.2"},
    FaultRow{8752, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x8120, 0x11, "CAN error counter passed error-passive limit", "transmit or receive error counter above 127"},
    FaultRow{8753, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Global, 0x1001, 0x11, "CAN message buffer overflow", "value 1 SDO response buffer, 2 SDO receive buffer (client sent before the previous answer), 3 PDO send buffer"},
    FaultRow{8754, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Global, 0x1001, 0x11, "CAN wrong communication mode", "p8700..p8737 written while NMT operational"},
    FaultRow{8755, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Global, 0x1001, 0x11, "CAN object not mappable", "mapping entry is not an allowed RPDO/TPDO object or sub-index is not 0; the COB-ID cannot be made valid while it is active"},
    FaultRow{8756, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Global, 0x1001, 0x11, "CAN mapped bytes exceeded", "sum of mapped lengths above 8 bytes"},
    FaultRow{8757, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Global, 0x1001, 0x11, "CAN set COB-ID invalid first", "mapping written while the PDO COB-ID is still valid (bit 31 = 0)"},
    FaultRow{8758, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Global, 0x1001, 0x11, "CAN maximum number of valid PDOs exceeded", "value 1: attempt to exceed 25 valid RPDOs on the unit; value 2: attempt to exceed p8848/p0115[0] valid TPDOs (FW 4.7; newer FW p8848/r8739). Cleared by POWER ON, warm restart (p0009=30,p0976=2), NMT reset node, NMT state change or p2111=0; newer FW also by a successful COB-ID write"},
    FaultRow{8759, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Global, 0x1001, 0x11, "CAN PDO COB-ID already in use", "COB-ID written is already assigned to another PDO; value = parameter number (edition 2023)"},
    FaultRow{8760, Kind::Alarm, Scope::Both, Reaction::None, kFixed, Acknowledge::None, Propagation::Global, 0x1001, 0x11, "CAN IF PZD size exceeded", "value 1 receive, 2 send: mapped data need more PZD words than IF2 offers; cleared like A08758"},
    FaultRow{30001, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Power unit overcurrent", "hardware overcurrent, value bits 0..2 phase, 3 DC link"},
    FaultRow{30002, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "DC link overvoltage", "Vdc above trip, value = Vdc in 0.1 V"},
    FaultRow{30003, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "DC link undervoltage", "Vdc below trip or supply lost"},
    FaultRow{30004, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Heat sink overtemperature", "value = temperature in 0.01 degC"},
    FaultRow{30005, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Power unit overload I2t", "r0036 = 100 %, value 16384 = 100 %"},
    FaultRow{30011, Kind::Fault, Scope::Axis, Reaction::Off2, kOff1, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Line phase failure", "DC link ripple too high"},
    FaultRow{30015, Kind::Fault, Scope::Axis, Reaction::Off2, kNone | kOff1 | kOff3, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Motor phase failure", "no current in one motor phase"},
    FaultRow{30016, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "Load supply switched out", "Vdc too low with pulses inhibited"},
    FaultRow{30017, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Hardware current limit too often", "limit responded repeatedly"},
    FaultRow{30021, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Ground fault", "sum of phase currents"},
    FaultRow{30022, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::PowerOn, Propagation::Local, 0x1000, 0x81, "Monitoring U_ce", "semiconductor short-circuit monitoring"},
    FaultRow{30024, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Thermal model overtemperature", "chip to heat sink difference"},
    FaultRow{30025, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Chip overtemperature", "value = difference in 0.01 degC"},
    FaultRow{30027, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Precharging time monitoring", "DC link not charged in time"},
    FaultRow{30035, Kind::Fault, Scope::Axis, Reaction::Off1, kOff2, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Air intake overtemperature", "air intake above limit"},
    FaultRow{30036, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Internal overtemperature", "electronics compartment above limit"},
    FaultRow{30040, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "24 V supply undervoltage", "electronics supply too low"},
    FaultRow{30502, Kind::Alarm, Scope::Axis, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "DC link overvoltage", "Vdc too high with pulses inhibited"},
    FaultRow{30600, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Safety STOP A initiated", "safe stop with pulse suppression"},
    FaultRow{30801, Kind::Fault, Scope::Axis, Reaction::Off2, kFixed, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "DRIVE-CLiQ sign-of-life missing", "lost cyclic communication with the power unit"},
    FaultRow{31100, Kind::Fault, Scope::Axis, Reaction::Encoder, kShortCircuit | kNone | kOff1 | kOff2 | kOff3 | kStop2, Acknowledge::PulseInhibit, Propagation::Local, 0x1000, 0x81, "Encoder 1 zero mark distance error", "zero mark pulses do not fit"},
    FaultRow{31110, Kind::Fault, Scope::Axis, Reaction::Encoder, kShortCircuit | kNone, Acknowledge::PulseInhibit, Propagation::Local, 0x1000, 0x81, "Encoder 1 serial communication error", "absolute protocol fault"},
    FaultRow{31111, Kind::Fault, Scope::Axis, Reaction::Encoder, kShortCircuit | kNone, Acknowledge::PulseInhibit, Propagation::Local, 0x1000, 0x81, "Encoder 1 internal error", "absolute encoder reports alarm bits"},
    FaultRow{31116, Kind::Fault, Scope::Axis, Reaction::Encoder, kShortCircuit | kNone, Acknowledge::Immediately, Propagation::Local, 0x1000, 0x81, "Encoder 1 amplitude error A+B", "track amplitude outside limits"},
    FaultRow{31118, Kind::Fault, Scope::Axis, Reaction::Encoder, kShortCircuit | kNone, Acknowledge::PulseInhibit, Propagation::Local, 0x1000, 0x81, "Encoder 1 speed difference", "speed jump larger than p0492"},
    FaultRow{31120, Kind::Fault, Scope::Axis, Reaction::Encoder, kShortCircuit | kNone, Acknowledge::PulseInhibit, Propagation::Local, 0x1000, 0x81, "Encoder 1 supply fault", "encoder supply voltage missing"},
    FaultRow{31150, Kind::Fault, Scope::Axis, Reaction::Encoder, kShortCircuit | kNone | kOff1 | kOff2 | kOff3 | kStop2, Acknowledge::PulseInhibit, Propagation::Local, 0x1000, 0x81, "Encoder 1 initialisation error", "encoder could not be started"},
    FaultRow{50011, Kind::Alarm, Scope::ControlUnit, Reaction::None, kFixed, Acknowledge::None, Propagation::Local, 0x0000, 0x00, "EtherNet/IP configuration faulty", "EtherNet/IP is served by a program of its own, if at all"},
};
// clang-format on

constexpr std::uint8_t kGenericBit = 0x01;
constexpr std::uint8_t kCommunicationBit = 0x10;
constexpr std::uint8_t kManufacturerBit = 0x80;

/// Error register and EMCY code follow from number and kind.
constexpr bool consistent(const FaultRow& row) {
  const bool communication = row.number >= 8700 && row.number < 8800;
  const bool alarm = row.kind == Kind::Alarm;
  const bool acknowledged = row.acknowledge != Acknowledge::None;
  const bool stops = row.alternatives == kOff1;
  if (alarm == acknowledged ||
      (alarm && (row.reaction != Reaction::None || (row.alternatives != kFixed && !stops))))
    return false;
  if ((row.alternatives & bit_of(row.reaction)) != 0 || row.cause.empty()) return false;
  if (communication) return row.error_register == (kGenericBit | kCommunicationBit) && row.emcy_code != 0;
  if (alarm) return row.error_register == 0 && row.emcy_code == 0;
  return row.error_register == (kGenericBit | kManufacturerBit) && row.emcy_code == 0x1000;
}

static_assert(std::adjacent_find(kRows.begin(), kRows.end(), [](const FaultRow& a, const FaultRow& b) {
                return a.number >= b.number;
              }) == kRows.end());
static_assert(kRows.size() <= kMostFaultRows);
static_assert(std::all_of(kRows.begin(), kRows.end(), consistent));

}  // namespace

std::span<const FaultRow> fault_rows() noexcept {
  return kRows;
}

const FaultRow* find_fault(std::uint16_t number) noexcept {
  const auto row = std::lower_bound(kRows.begin(), kRows.end(), number,
                                    [](const FaultRow& r, std::uint16_t n) { return r.number < n; });
  return row != kRows.end() && row->number == number ? &*row : nullptr;
}

std::string fault_text(const FaultRow& row) {
  return message_code(row.number, row.kind);
}

std::string message_code(std::uint16_t number, Kind kind) {
  return fmt::format("{}{:05}", kind == Kind::Fault ? 'F' : 'A', number);
}

}  // namespace drive
