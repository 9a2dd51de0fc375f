#include "tests/drive/positioning/positioning_scenarios.hpp"

#include "tests/drive/positioning/scenario_steps.hpp"

namespace drive {

std::vector<Scenario> positioning_scenarios() {
  using namespace scenario;
  constexpr std::size_t kEncoder1 = 1;
  return {
      {7440, plain, [](TestedUnit& unit) { unit.set(2574, 50.0); }},
      {7441, with_absolute_encoder, [](TestedUnit& unit) { unit.set(2507, 2.0); }},
      {7442, with_absolute_encoder,
       [](TestedUnit& unit) {
         unit.set(2576, 70000.0);
         unit.set(2577, 1.0);
       }},
      {7443, with_absolute_encoder,
       [](TestedUnit& unit) {
         unit.set(2599, 160000.0);
         unit.set(2507, 2.0);
       },
       159999},
      {7450, plain,
       [](TestedUnit& unit) {
         enable_and_reference(unit);
         unit.set(2546, 0.0);
         unit.set(2544, 0.0);
         unit.set(1520, 0.1);
         unit.set(1521, -0.1);
         unit.axis().set_load_torque(3.0);
       }},
      {7451, plain,
       [](TestedUnit& unit) {
         unit.set(2534, 0.0);
         unit.set(2542, 0.0);
         unit.set(2544, 1.0);
         unit.set(2545, 100.0);
         enable_and_reference(unit);
         unit.move(20000.0);
       }},
      {7452, plain,
       [](TestedUnit& unit) {
         enable_and_reference(unit);
         unit.set(1520, 0.1);
         unit.set(1521, -0.1);
         unit.axis().set_load_torque(3.0);
       }},
      {7453, plain, [](TestedUnit& unit) { EXPECT_TRUE(unit.unit.raise(TestedUnit::kAxis, 31116)); }},
      {7454, plain, [](TestedUnit& unit) { unit.set(2502, 0.0); }},
      {7455, plain,
       [](TestedUnit& unit) {
         unit.set(2576, 900.0);
         unit.set(2577, 1.0);
       }},
      {7456, plain,
       [](TestedUnit& unit) {
         enable_and_reference(unit);
         unit.set(2571, 500.0);
         unit.move(90000.0);
       }},
      {7457, plain,
       [](TestedUnit& unit) {
         unit.enable();
         unit.set(2589, 1.0);
         unit.set(2590, 1.0);
       }},
      {7458, plain,
       [](TestedUnit& unit) {
         unit.set(2606, 5000.0);
         search(unit);
       }},
      {7459, plain,
       [](TestedUnit& unit) {
         unit.set(2607, 0.0);
         unit.set(2609, 500.0);
         search(unit);
       }},
      {7460, plain,
       [](TestedUnit& unit) {
         unit.set_reference(-2147482000.0);
         unit.set(2612, 1.0);
         search(unit);
       }},
      {7461, plain,
       [](TestedUnit& unit) {
         unit.enable();
         unit.block(0, {.number = 1});
         unit.set(2625, 1.0);
         unit.set(2631, 1.0);
       }},
      {7462, plain, [](TestedUnit& unit) { start(unit, {.number = 2}); }, 1},
      {7463, plain,
       [](TestedUnit& unit) {
         unit.block(1, {.number = 5});
         start(unit, {.number = 1, .position = 100.0, .mode = 0x50});
       },
       1},
      {7464, plain, [](TestedUnit& unit) { start(unit, {.number = 1, .task = 5, .parameter = -1.0}); }, 1},
      {7465, plain, [](TestedUnit& unit) { unit.block(0, {.number = 7, .mode = 0x10}); }, 7},
      {7466, plain, checked({.number = 5}), 5},
      {7467, plain, checked({.number = 1, .task = 9, .parameter = 2.0}), 1},
      {7468, plain, checked({.number = 1, .task = 6, .parameter = 9.0}), 1},
      {7469, plain,
       [](TestedUnit& unit) {
         activate_limits_outside(unit, -100.0, 100.0);
         checked({.number = 1, .position = -101.0})(unit);
       },
       1},
      {7470, plain,
       [](TestedUnit& unit) {
         activate_limits_outside(unit, -100.0, 100.0);
         checked({.number = 1, .position = 101.0})(unit);
       },
       1},
      {7471, plain,
       [](TestedUnit& unit) {
         unit.set(2577, 1.0);
         checked({.number = 1, .position = 360000.0})(unit);
       },
       1},
      {7472, plain, checked({.number = 1, .mode = 0x200}), 1},
      {7473, plain, [](TestedUnit& unit) { jog_from(unit, -2147480000.0, 2589); }},
      {7474, plain, [](TestedUnit& unit) { jog_from(unit, 2147480000.0, 2590); }},
      {7475, plain,
       [](TestedUnit& unit) {
         unit.set_reference(-2147480000.0);
         unit.enable();
         unit.move(-9000.0, 6000.0, false);
       }},
      {7476, plain,
       [](TestedUnit& unit) {
         unit.set_reference(2147480000.0);
         unit.enable();
         unit.move(9000.0, 6000.0, false);
       }},
      {7477, plain, [](TestedUnit& unit) { move_within_limits(unit, -20001.0); }},
      {7478, plain, [](TestedUnit& unit) { move_within_limits(unit, 20001.0); }},
      {7479, plain, [](TestedUnit& unit) { move_within_limits(unit, -20001.0); }},
      {7480, plain, [](TestedUnit& unit) { move_within_limits(unit, 20001.0); }},
      {7481, plain, [](TestedUnit& unit) { activate_limits_outside(unit, 1000.0, 2000.0); }},
      {7482, plain, [](TestedUnit& unit) { activate_limits_outside(unit, -2000.0, -1000.0); }},
      {7483, with_wall,
       [](TestedUnit& unit) {
         unit.set(2639, 0.0);
         clamp(unit);
       }},
      {7484, with_wall,
       [](TestedUnit& unit) {
         clamp(unit);
         EXPECT_TRUE(unit.run_until([&] { return unit.bit(2683, 12); }, 8000));
         unit.axis().set_load_torque(8.0);
       }},
      {7485, plain, [](TestedUnit& unit) { clamp(unit); }},
      {7486, plain,
       [](TestedUnit& unit) {
         unit.set(2640, 0.0);
         start(unit, {.number = 1});
       }},
      {7487, plain,
       [](TestedUnit& unit) {
         unit.set(2641, 0.0);
         start(unit, {.number = 1});
       }},
      {7488, plain,
       [](TestedUnit& unit) {
         enable_and_reference(unit);
         unit.set(2649, 1.0);
         unit.set(2647, 1.0);
       }},
      {7489, with_probe,
       [](TestedUnit& unit) {
         enable_and_reference(unit);
         unit.set(488, 4.0);
         unit.set(2602, 10.0);
         unit.set(2597, 1.0);
         unit.set(2595, 1.0);
         unit.run(2);
         unit.move(20000.0);
       }},
      {7490, plain,
       [](TestedUnit& unit) {
         enable_and_reference(unit);
         unit.move(90000.0);
         unit.control(0x0006);
       }},
      {7491, plain,
       [](TestedUnit& unit) {
         unit.set(2568, 1.0);
         unit.set(2569, 0.0);
       }},
      {7492, plain,
       [](TestedUnit& unit) {
         unit.set(2568, 1.0);
         unit.set(2570, 0.0);
       }},
      {7493, plain,
       [](TestedUnit& unit) {
         unit.set_reference(2147480000.0);
         unit.set(2690, 100000.0);
         unit.wire(2516, {2690, kOwnObject, 0});
       },
       1},
      {7495, plain,
       [](TestedUnit& unit) {
         search(unit);
         unit.run(50);
         unit.set(2595, 0.0);
       }},
      {7496, plain, [](TestedUnit& unit) { unit.set(2590, 1.0); }, 1},
      {7497, plain, [](TestedUnit& unit) { unit.set(2514, 1.0); }},
      {7498, plain,
       [](TestedUnit& unit) {
         unit.set(2597, 1.0);
         unit.set(2595, 1.0);
       },
       6},
      {7499, plain,
       [](TestedUnit& unit) {
         search(unit);
         unit.run(50);
         unit.set(2613, 0.0);
       }},
      {7503, plain,
       [](TestedUnit& unit) {
         unit.set(2568, 1.0);
         jog_from(unit, 0.0, 2590);
         unit.run(50);
         unit.set(2569, 0.0);
       }},
      {7505, plain,
       [](TestedUnit& unit) {
         unit.set(1300, 20.0);
         unit.set(2656, 1.0);
         unit.set_reference();
         unit.block(0, {.number = 1, .task = 2, .parameter = 100.0});
         unit.set(2625, 1.0);
         unit.set(2631, 1.0);
       },
       1},
      {7557, plain,
       [](TestedUnit& unit) {
         unit.set(2577, 1.0);
         unit.run(2);
         unit.set(2599, -1.0);
         unit.set(2596, 1.0);
       }},
      {7577, plain, [](TestedUnit& unit) { unit.set(2509, 1.0, kEncoder1); }, 6},
      {7581, plain, [](TestedUnit& unit) { EXPECT_TRUE(unit.unit.raise(TestedUnit::kAxis, 31116)); }},
      {7584, plain, [](TestedUnit& unit) { unit.set(2514, 1.0, kEncoder1); }},
      {7593, plain,
       [](TestedUnit& unit) {
         unit.set(2690, 2147482000.0);
         unit.wire(2515, {2690, kOwnObject, 0}, kEncoder1);
         unit.set(2514, 1.0, kEncoder1);
         unit.run(3);
         unit.set(2514, 0.0, kEncoder1);
         unit.run(3);
         unit.wire(2516, {2690, kOwnObject, 0}, kEncoder1);
       },
       1},
      {7596, plain,
       [](TestedUnit& unit) {
         unit.set(2508, 1.0, kEncoder1);
         unit.run(5);
         unit.set(2508, 0.0, kEncoder1);
       }},
  };
}

}  // namespace drive
