#include "tests/drive/measuring_axis.hpp"
#include <fmt/format.h>
using namespace drive;
TEST(Try, All){
  std::mt19937_64 random{1};
  for (auto& p : identification::presets()) {
    auto d = identification::random_deviation(random);
    MeasuringAxis a{real_axis(p.name, d, {.inertia = 2*p.machine.inertia})};
    auto real = motor::real_machine(p.machine, d);
    double t = a.measure(1910);
    fmt::print("{:12} standstill {:.2f} s state {} 1910={} faults {}", p.name, t, int(a.state()), a.shown(1910), a.axis.messages().faults().size());
    for (auto& f : a.axis.messages().faults()) fmt::print(" F{} {}", f.row->number, f.value);
    fmt::print("\n  R {:.4f}", a.shown(350)/real.stator_resistance);
    if (real.type == motor::MachineType::Synchronous) fmt::print(" Ld {:.4f} Lq {:.4f} pole {:.2f}\n", a.shown(357)*1e-3/real.synchronous.d_inductance, a.shown(356)*1e-3/real.synchronous.q_inductance, a.shown(1984));
    else fmt::print(" RR {:.4f} LM {:.4f} Rr {:.4f}\n", a.shown(1927)/motor::induction_circuit(real).rotor_resistance, a.shown(1936)*1e-3/motor::induction_circuit(real).magnetising_inductance, a.shown(354)/real.induction.rotor_resistance);
    t = a.measure(1960);
    fmt::print("   rotating {:.2f} s state {} 1960={} faults {}", t, int(a.state()), a.shown(1960), a.axis.messages().faults().size());
    for (auto& f : a.axis.messages().faults()) fmt::print(" F{} {}", f.row->number, f.value);
    double J = real.inertia + 2*p.machine.inertia;
    fmt::print("\n  J {:.4f} {:.4f}", a.shown(1969)/J, a.shown(341)*a.shown(342)/J);
    if (real.type == motor::MachineType::Synchronous) fmt::print(" kt {:.4f}\n", a.shown(316)/p.machine.torque_constant/d.magnet_flux);
    else { fmt::print(" char"); for (int i=362;i<370;++i) fmt::print(" {:.2f}", a.shown(uint16_t(i))); fmt::print("\n"); }
  }
}
