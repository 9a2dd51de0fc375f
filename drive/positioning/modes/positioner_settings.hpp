#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace drive {

class Positioner;

inline constexpr std::size_t kTraversingBlocks = 64;

/// What the parameters of the basic positioner hold: LU, LU/s, LU/s², LU/s³, shares of 1.
struct PositionerSettings {
  using Block = Positioner;
  template <class Value>
  using Table = std::array<Value, kTraversingBlocks>;

  double maximum_velocity = 0.0;      ///< p2571
  double maximum_acceleration = 0.0;  ///< p2572
  double maximum_deceleration = 0.0;  ///< p2573
  double jerk = 0.0;                  ///< p2574
  double modulo_range = 0.0;          ///< p2576
  double software_limit_minus = 0.0;  ///< p2580
  double software_limit_plus = 0.0;   ///< p2581

  std::array<double, 2> jog_velocity{};  ///< p2585, p2586, signed
  std::array<double, 2> jog_distance{};  ///< p2587, p2588

  double reference_coordinate = 0.0;      ///< p2599
  double reference_offset = 0.0;          ///< p2600
  double inner_window = 0.0;              ///< p2601, 0 = off
  double outer_window = 0.0;              ///< p2602, 0 = off
  double cam_velocity = 0.0;              ///< p2605
  double longest_way_to_cam = 0.0;        ///< p2606
  std::int32_t has_cam = 0;               ///< p2607
  double mark_velocity = 0.0;             ///< p2608
  double longest_way_to_mark = 0.0;       ///< p2609, from the end of the cam
  double mark_tolerance = 0.0;            ///< p2610
  double reference_point_velocity = 0.0;  ///< p2611

  std::int32_t block_count = 0;                ///< p2615, entries that count
  Table<std::int32_t> block_number{};          ///< p2616, -1 = no block
  Table<std::int32_t> block_position{};        ///< p2617
  Table<double> block_velocity{};              ///< p2618
  Table<double> block_acceleration{};          ///< p2619
  Table<double> block_deceleration{};          ///< p2620
  Table<std::int32_t> block_task{};            ///< p2621
  Table<std::int32_t> block_task_parameter{};  ///< p2622
  Table<std::int32_t> block_task_mode{};       ///< p2623
  std::int32_t external_change = 0;            ///< p2632: 0 measuring probe, 1 p2633

  double fixed_stop_following_error = 0.0;  ///< p2634
  double fixed_stop_window = 0.0;           ///< p2635

  double mdi_position = 0.0;      ///< p2690
  double mdi_velocity = 0.0;      ///< p2691
  double mdi_acceleration = 1.0;  ///< p2692
  double mdi_deceleration = 1.0;  ///< p2693
};

/// What interconnections bring to the basic positioner; integer connectors in LU and LU/s, shares of 1.
struct PositionerInputs {
  using Block = Positioner;

  bool stop_cams_active = false;  ///< p2568
  bool stop_cam_minus = true;     ///< p2569, 0 = reached
  bool stop_cam_plus = true;      ///< p2570, 0 = reached
  bool limits_jerk = false;       ///< p2575
  bool modulo = false;            ///< p2577
  bool software_limits = false;   ///< p2582

  bool jog_1 = false;            ///< p2589
  bool jog_2 = false;            ///< p2590
  bool jog_incremental = false;  ///< p2591

  bool reference = false;           ///< p2595, edge starts, 0 interrupts
  bool set_reference = false;       ///< p2596, edge
  bool reference_flying = false;    ///< p2597: 0 search, 1 flying
  bool search_negative = false;     ///< p2604
  bool reference_cam = false;       ///< p2612
  bool reversing_cam_minus = true;  ///< p2613, 0 = reached
  bool reversing_cam_plus = true;   ///< p2614, 0 = reached

  std::array<bool, 6> block_selection{};  ///< p2625 to p2630
  bool activate_task = false;             ///< p2631, edge
  bool external_change = false;           ///< p2633, edge
  bool fixed_stop_reached = false;        ///< p2637
  bool fixed_stop_left = false;           ///< p2638
  bool torque_limit_reached = false;      ///< p2639
  bool no_intermediate_stop = false;      ///< p2640, 0 = stop
  bool no_reject = false;                 ///< p2641, 0 = reject

  bool mdi = false;             ///< p2647
  bool mdi_absolute = false;    ///< p2648
  bool mdi_continuous = false;  ///< p2649
  bool mdi_transfer = false;    ///< p2650, edge
  bool mdi_positive = false;    ///< p2651
  bool mdi_negative = false;    ///< p2652
  bool mdi_setting_up = false;  ///< p2653

  std::array<bool, 2> tracking{};     ///< p2655
  bool enable = false;                ///< p2656
  bool position_valid = false;        ///< p2658
  bool measures = false;              ///< p2659, a mark or a probe is awaited
  bool measured_value_valid = false;  ///< p2661
  bool adjusted = false;              ///< p2662
  bool clamped = false;               ///< p2663

  double software_limit_minus = 0.0;             ///< p2578
  double software_limit_plus = 0.0;              ///< p2579
  double units_per_revolution = 0.0;             ///< p2593, of the motor
  std::array<double, 3> external_velocity{};     ///< p2594: absolute, positive, negative; 0 = none
  std::array<double, 4> reference_coordinate{};  ///< p2598
  double mdi_position = 0.0;                     ///< p2642
  double mdi_velocity = 0.0;                     ///< p2643
  double mdi_acceleration = 1.0;                 ///< p2644
  double mdi_deceleration = 1.0;                 ///< p2645
  double velocity_override = 1.0;                ///< p2646
  double mdi_mode = 0.0;                         ///< p2654
  double actual_position = 0.0;                  ///< p2657
  double measured_position = 0.0;                ///< p2660

  friend bool operator==(const PositionerInputs&, const PositionerInputs&) = default;
};

}  // namespace drive
