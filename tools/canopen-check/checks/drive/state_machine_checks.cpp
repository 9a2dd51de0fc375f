#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/drive/axis.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"

// The state machine of CiA 402-2 by controlword, with and without faults.
namespace conformance {
namespace {

constexpr std::uint16_t kAbortOption = 0x6007, kQuickStopOption = 0x605A;

/// One command, and the state that it has to lead to from the one before.
struct Transition {
  std::uint16_t command;
  const DriveState* state;
  const char* text;
};
/// From Switch on disabled on, and back to it. Quick stop, 11 and 16, is a check of its own.
constexpr std::array kWalk{
    Transition{kShutdown, &kReadyToSwitchOn, "Shutdown, transition 2"},
    Transition{kDisableVoltage, &kSwitchOnDisabled, "Disable voltage, transition 7"},
    Transition{kShutdown, &kReadyToSwitchOn, "Shutdown, transition 2"},
    Transition{kQuickStop, &kSwitchOnDisabled, "Quick stop, transition 7"},
    Transition{kShutdown, &kReadyToSwitchOn, "Shutdown, transition 2"},
    Transition{kSwitchOn, &kSwitchedOn, "Switch on, transition 3"},
    Transition{kShutdown, &kReadyToSwitchOn, "Shutdown, transition 6"},
    Transition{kSwitchOn, &kSwitchedOn, "Switch on, transition 3"},
    Transition{kDisableVoltage, &kSwitchOnDisabled, "Disable voltage, transition 10"},
    Transition{kShutdown, &kReadyToSwitchOn, "Shutdown, transition 2"},
    Transition{kSwitchOn, &kSwitchedOn, "Switch on, transition 3"},
    Transition{kQuickStop, &kSwitchOnDisabled, "Quick stop, transition 10"},
    Transition{kShutdown, &kReadyToSwitchOn, "Shutdown, transition 2"},
    Transition{kSwitchOn, &kSwitchedOn, "Switch on, transition 3"},
    Transition{kEnableOperation, &kOperationEnabled, "Enable operation, transition 4"},
    Transition{kSwitchOn, &kSwitchedOn, "Disable operation, transition 5"},
    Transition{kEnableOperation, &kOperationEnabled, "Enable operation, transition 4"},
    Transition{kShutdown, &kReadyToSwitchOn, "Shutdown, transition 8"},
    Transition{kSwitchOn, &kSwitchedOn, "Switch on, transition 3"},
    Transition{kEnableOperation, &kOperationEnabled, "Enable operation, transition 4"},
    Transition{kDisableVoltage, &kSwitchOnDisabled, "Disable voltage, transition 9"},
};

void follows_its_commands(Axis& axis) {
  for (const Transition& transition : kWalk) {
    axis.context().step();
    axis.command(transition.command);
    if (axis.reaches(*transition.state)) continue;
    axis.fail(kStatusword, fmt::format("{} after {}", transition.state->name, transition.text),
              state_in(axis.status()));
    return;
  }
}

/// False, and a finding, if @p word takes the axis out of @p state.
bool ignores(Axis& axis, std::uint16_t word, const DriveState& state, const char* command) {
  axis.context().step();
  axis.command(word);
  if (!axis.await(kWatch / 2, [&] { return !state.is(axis.status()); })) return true;
  return axis.fail(kStatusword, fmt::format("{} in spite of {}, {:04X}h", state.name, command, word),
                   state_in(axis.status()));
}

void ignores_other_commands(Axis& axis) {
  const bool disabled = ignores(axis, kSwitchOn, kSwitchOnDisabled, "Switch on") &&
                        ignores(axis, kEnableOperation, kSwitchOnDisabled, "Enable operation") &&
                        ignores(axis, kQuickStop, kSwitchOnDisabled, "Quick stop") &&
                        ignores(axis, kFaultReset, kSwitchOnDisabled, "Fault reset");
  axis.command(kShutdown);
  if (!disabled || !axis.reaches(kReadyToSwitchOn)) return;
  axis.command(kSwitchOn);
  if (!axis.reaches(kSwitchedOn) || !ignores(axis, kSwitchOn, kSwitchedOn, "Switch on once more")) return;
  axis.command(kEnableOperation);
  if (axis.reaches(kOperationEnabled))
    (void)ignores(axis, kEnableOperation, kOperationEnabled, "Enable operation once more");
}

/// A fault by 6007h: Pre-operational in Operation enabled; the node is in Operational again afterwards.
bool provoke_fault(Axis& axis) {
  Session& session = axis.context().session();
  if (!axis.set_if_there(kAbortOption, 1) || !axis.enable()) return false;
  session.command(canopen::NmtCommand::EnterPreOperational);
  const bool fault = axis.reaches(kFault, std::chrono::seconds{2});
  session.command(canopen::NmtCommand::Start);
  session.pass(std::chrono::milliseconds{100});
  return fault ||
         axis.skip("leaving Operational in Operation enabled is no fault, and no other one can be provoked");
}

void resets_faults(Axis& axis) {
  if (!provoke_fault(axis)) return;
  for (const std::uint16_t word : {kDisableVoltage, kShutdown, kSwitchOn, kEnableOperation})
    if (!ignores(axis, word, kFault, "a command that is not Fault reset")) return;
  axis.command(kDisableVoltage);
  axis.context().step();
  axis.command(kFaultReset);
  if (!axis.reaches(kSwitchOnDisabled))
    axis.fail(kStatusword, "Switch on disabled after Fault reset, transition 15", state_in(axis.status()));
}

void leaves_quick_stop(Axis& axis) {
  constexpr std::int64_t kStay = 6;
  if (!axis.needs({kQuickStopOption}) || !axis.set(kQuickStopOption, kStay) || !axis.enable()) return;
  axis.context().step();
  axis.command(kQuickStop);
  if (!axis.reaches(kQuickStopActive) || axis.await(kWatch, [&] { return !kQuickStopActive.is(axis.status()); })) {
    axis.fail(kStatusword, "Quick stop active after Quick stop with 605Ah = 6, transition 11",
              state_in(axis.status()));
    return;
  }
  axis.context().step();
  axis.command(kEnableOperation);
  if (!axis.reaches(kOperationEnabled, kBitPatience)) {
    axis.context().note("Enable operation does not lead from Quick stop active: no transition 16");
  } else {
    axis.command(kQuickStop);
    (void)axis.reaches(kQuickStopActive);
  }
  axis.context().step();
  axis.command(kDisableVoltage);
  if (!axis.reaches(kSwitchOnDisabled))
    axis.fail(kStatusword, "Switch on disabled after Disable voltage, transition 12", state_in(axis.status()));
}

constexpr std::array kChecks{
    moving_check<follows_its_commands>("drive.state-machine",
                                       "The state machine follows its commands: transitions 2 to 10",
                                       "CiA 402-2 6040h, FSA"),
    moving_check<ignores_other_commands>(
        "drive.forbidden-commands", "Commands that a state does not know have no effect", "CiA 402-2 6040h, FSA"),
    moving_check<leaves_quick_stop>("drive.quick-stop-transitions",
                                    "Quick stop active is entered and left by transitions 11, 12 and 16",
                                    "CiA 402-2 6040h, FSA"),
    moving_check<resets_faults>("drive.fault-reset",
                                "A fault leads to Fault, which Fault reset alone ends: transitions 13 to 15",
                                "CiA 402-2 6040h, FSA"),
};

}  // namespace

std::span<const Check> drive_state_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
