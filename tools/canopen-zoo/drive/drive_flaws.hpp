#pragma once

namespace zoo {

/// What a drive does otherwise than CiA 402-2 says. Nothing by default.
struct DriveFlaws {
  // State machine and modes.
  bool boots_ready = false;                ///< into Ready to switch on
  bool enables_directly = false;           ///< Enable operation leads out of Switch on disabled
  bool disables_to_ready = false;          ///< Disable operation leads to Ready to switch on
  bool leaves_fault_by_shutdown = false;   ///< without Fault reset
  bool ignores_quick_stop_option = false;  ///< every quick stop ends in Switch on disabled
  bool stays_in_quick_stop = false;        ///< whatever 605Ah says
  bool does_not_brake = false;             ///< in Quick stop active
  bool shows_no_homing_mode = false;       ///< 6061h stays when 6060h is 6
  bool takes_any_mode = false;
  bool takes_any_option = false;
  bool boots_into_mode_5 = false;  ///< 6061h is 5 until 6060h is written

  // Motion.
  bool turns_the_other_way = false;
  bool never_reaches_velocity = false;  ///< bit 10
  bool turns_on_halt = false;
  bool positions_on_halt = false;
  bool forgets_target_on_halt = false;
  bool hides_halt = false;  ///< bit 10
  bool ignores_software_limits = false;
  bool ignores_highest_velocity = false;
  bool ignores_highest_speed = false;

  // Profile position and homing mode.
  bool never_acknowledges = false;
  bool keeps_acknowledge = false;
  bool takes_every_target = false;  ///< a change of 607Ah is a set-point
  bool never_reaches_target = false;
  bool always_at_target = false;
  bool takes_relative_for_absolute = false;
  bool ignores_change_immediately = false;
  bool drops_waiting = false;  ///< every set-point counts at once
  bool moves_on_enable = false;
  bool goes_on_when_enabled = false;
  bool never_attains_home = false;
  bool forgets_home_offset = false;
  bool takes_any_method = false;
};

}  // namespace zoo
