#include "tools/canopen-zoo/drive/drive_objects.hpp"
#include "tools/canopen-zoo/wrong/wrong_slaves.hpp"

namespace zoo {
namespace {

/// A drive of another profile, as its EDS says too.
Defect of_another_profile() {
  return {.table = [](auto& table) { row(table, 0x1000).initial = kDriveType - 1; },
          .eds =
              [](std::string& eds) {
                const std::size_t type = eds.find("0x20192");
                eds.replace(type, 7, "0x20191");
              },
          .drive = DriveFlaws{}};
}

std::vector<WrongSlave> wrong_machines() {
  return {
      {"IsADriveOfAnotherProfile",
       "1000h names profile 401, and it has objects of CiA 402.",
       of_another_profile(),
       {"drive.device-type"}},
      {"BootsIntoAModeItDoesNotHave",
       "6061h is 5 after boot-up, which 6502h does not have.",
       {.drive = DriveFlaws{.boots_into_mode_5 = true}},
       {"drive.mode-display"}},
      {"BootsReadyToSwitchOn",
       "It boots into Ready to switch on.",
       {.drive = DriveFlaws{.boots_ready = true}},
       {"drive.boot-state"}},
      {"DoesNotShowHomingMode",
       "6061h stays when 6 is written to 6060h.",
       {.drive = DriveFlaws{.shows_no_homing_mode = true}},
       {"drive.mode-change"}},
      {"TakesAnyMode",
       "6061h follows 6060h to modes that 6502h does not have.",
       {.drive = DriveFlaws{.takes_any_mode = true}},
       {"drive.unsupported-mode"}},
      {"EnablesDirectly",
       "Enable operation leads from Switch on disabled to Operation enabled.",
       {.drive = DriveFlaws{.enables_directly = true}},
       {"drive.forbidden-commands"}},
      {"DisablesToReadyToSwitchOn",
       "Disable operation leads to Ready to switch on, not to Switched on.",
       {.drive = DriveFlaws{.disables_to_ready = true}},
       {"drive.state-machine"}},
      {"LeavesFaultByShutdown",
       "Shutdown ends Fault without Fault reset.",
       {.drive = DriveFlaws{.leaves_fault_by_shutdown = true}},
       {"drive.fault-reset"}},
      {"IgnoresTheQuickStopOption",
       "Every quick stop ends in Switch on disabled, whatever 605Ah says.",
       {.drive = DriveFlaws{.ignores_quick_stop_option = true}},
       {"drive.quick-stop", "drive.quick-stop-transitions"}},
      {"StaysInQuickStopActive",
       "Every quick stop stays in Quick stop active, whatever 605Ah says.",
       {.drive = DriveFlaws{.stays_in_quick_stop = true}},
       {"drive.quick-stop"}},
      {"TurnsOnAfterAQuickStop",
       "It goes on at the velocity that it has in Quick stop active.",
       {.drive = DriveFlaws{.does_not_brake = true}},
       {"drive.quick-stop"}},
      {"TakesReservedOptionCodes",
       "It confirms values of 6007h, 605Ah and 605Dh that are reserved.",
       {.drive = DriveFlaws{.takes_any_option = true}},
       {"drive.option-code-range"}},
  };
}

std::vector<WrongSlave> wrong_motions() {
  return {
      {"TurnsTheOtherWay",
       "It turns in the negative direction with a positive 60FFh.",
       {.drive = DriveFlaws{.turns_the_other_way = true}},
       {"drive.profile-velocity"}},
      {"NeverReachesItsVelocity",
       "Bit 10 of the statusword stays 0 in profile velocity mode.",
       {.drive = DriveFlaws{.never_reaches_velocity = true}},
       {"drive.profile-velocity"}},
      {"TurnsOnWithHalt",
       "Halt does not stop it in profile velocity mode.",
       {.drive = DriveFlaws{.turns_on_halt = true}},
       {"drive.halt"}},
      {"PositionsOnWithHalt",
       "Halt does not stop it in profile position mode.",
       {.drive = DriveFlaws{.positions_on_halt = true}},
       {"drive.halt-positioning"}},
      {"ForgetsItsTargetWithHalt",
       "A positioning that halt has stopped does not go on without it.",
       {.drive = DriveFlaws{.forgets_target_on_halt = true}},
       {"drive.halt-positioning"}},
      {"DoesNotTellThatHaltIsDone",
       "Bit 10 of the statusword stays 0 at rest with halt.",
       {.drive = DriveFlaws{.hides_halt = true}},
       {"drive.halt", "drive.halt-positioning"}},
      {"IgnoresSoftwareLimits",
       "It goes to targets beyond 607Dh.",
       {.drive = DriveFlaws{.ignores_software_limits = true}},
       {"drive.software-limits"}},
      {"IgnoresTheHighestProfileVelocity",
       "It turns faster than 607Fh says.",
       {.drive = DriveFlaws{.ignores_highest_velocity = true}},
       {"drive.max-profile-velocity"}},
      {"IgnoresTheHighestMotorSpeed",
       "It turns faster than 6080h says.",
       {.drive = DriveFlaws{.ignores_highest_speed = true}},
       {"drive.max-motor-speed"}},
  };
}

std::vector<WrongSlave> wrong_positionings() {
  return {
      {"NeverAcknowledges",
       "Bit 12 of the statusword stays 0 in profile position mode.",
       {.drive = DriveFlaws{.never_acknowledges = true}},
       {"drive.set-point-acknowledge"}},
      {"KeepsItsAcknowledge",
       "Bit 12 of the statusword stays 1 in profile position mode.",
       {.drive = DriveFlaws{.keeps_acknowledge = true}},
       {"drive.set-point-acknowledge"}},
      {"TakesEveryTarget",
       "It goes to 607Ah as soon as that changes, without bit 4.",
       {.drive = DriveFlaws{.takes_every_target = true}},
       {"drive.set-point-edge"}},
      {"NeverReachesItsTarget",
       "Bit 10 of the statusword stays 0 in profile position mode.",
       {.drive = DriveFlaws{.never_reaches_target = true}},
       {"drive.target-reached"}},
      {"IsAlwaysAtItsTarget",
       "Bit 10 of the statusword stays 1 in profile position mode.",
       {.drive = DriveFlaws{.always_at_target = true}},
       {"drive.target-reached"}},
      {"TakesRelativeForAbsolute",
       "It ignores bit 6 of the controlword: 607Ah is always absolute.",
       {.drive = DriveFlaws{.takes_relative_for_absolute = true}},
       {"drive.relative"}},
      {"FinishesTheFirstSetPoint",
       "It ignores bit 5 of the controlword: a new set-point always waits.",
       {.drive = DriveFlaws{.ignores_change_immediately = true}},
       {"drive.change-immediately"}},
      {"DropsWaitingSetPoints",
       "A new set-point replaces the one before without bit 5 too.",
       {.drive = DriveFlaws{.drops_waiting = true}},
       {"drive.set-point-order"}},
      {"MovesWhenItIsEnabled",
       "It goes to 607Ah when it is enabled in profile position mode.",
       {.drive = DriveFlaws{.moves_on_enable = true}},
       {"drive.old-set-point"}},
      {"GoesOnWhenItIsEnabledAgain",
       "A positioning that was interrupted by disabling goes on when it is enabled again.",
       {.drive = DriveFlaws{.goes_on_when_enabled = true}},
       {"drive.old-set-point"}},
      {"NeverAttainsHome",
       "Bit 12 of the statusword stays 0 in homing mode.",
       {.drive = DriveFlaws{.never_attains_home = true}},
       {"drive.homing"}},
      {"ForgetsTheHomeOffset",
       "6064h is 0 after homing on the present position, whatever 607Ch says.",
       {.drive = DriveFlaws{.forgets_home_offset = true}},
       {"drive.homing"}},
      {"TakesReservedHomingMethods",
       "It takes method 15, which is reserved, and attains home with it.",
       {.drive = DriveFlaws{.takes_any_method = true}},
       {"drive.homing-method"}},
  };
}

}  // namespace

std::vector<WrongSlave> wrong_drive_slaves() {
  std::vector<WrongSlave> slaves;
  for (const auto more : {wrong_machines, wrong_motions, wrong_positionings})
    for (WrongSlave& slave : more()) slaves.push_back(std::move(slave));
  return slaves;
}

}  // namespace zoo
