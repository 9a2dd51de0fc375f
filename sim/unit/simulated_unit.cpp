#include "sim/unit/simulated_unit.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "sim/base/allocations.hpp"
#include "sim/wire/identity.hpp"

namespace sim {
namespace {

/// From when something is there for a program until it runs (us).
constexpr std::int64_t kQuickest = 1, kSlowest = 60;
/// What the disk takes for a write (us).
constexpr std::int64_t kQuickestWrite = 100, kSlowestWrite = 60'000;

}  // namespace

SimulatedUnit::SimulatedUnit(const UnitSite& site, std::size_t number, const axisd::Configuration& configuration,
                             bool is_watched, Draw draw)
    : site_{site},
      number_{number},
      configuration_{configuration},
      is_watched_{is_watched},
      draw_{draw},
      folder_{fmt::format("/{}", number)},
      disk_{draw_.fork()},
      identity_{identity_named(fmt::format("unit-{}", number), process_of_unit(number))} {}

SimulatedUnit::~SimulatedUnit() {
  cut_power();
}

template <class Tell>
void SimulatedUnit::tell(Tell tell) noexcept {
  const Uncounted uncounted;
  for (const auto& judge : site_.judges) tell(*judge);
}

void SimulatedUnit::switch_on() {
  if (instance_) return;
  if (!disk_.has_power()) disk_.return_power();
  tell([&](Judge& judge) { judge.on_power(*this, true); });
  PortListener& port_listener = *this;
  axisd::InstanceListener& listener = *this;
  auto port = std::make_unique<SimulatedPort>(site_.medium, site_.time, identity_, port_listener);
  auto link = std::make_unique<SimulatedLink>();
  port_ = port.get();
  link_ = link.get();
  if (!link_is_up_) {
    port_->set_up(false);
    link_->change(bus::LinkState::Down);
    static_cast<void>(link_->read());
  }
  instance_ = std::make_unique<axisd::Instance>(configuration_, bus::Connection{std::move(port), std::move(link)},
                                                folder_, site_.log, listener);
  instance_->load();
  instance_->tell_events(true);
  if (is_watched_) instance_->device().runner().observe(this);
  instance_->start();
  plan_turn();
}

void SimulatedUnit::cut_power() noexcept {
  if (!instance_) return;
  disk_.cut_power();
  leave();
}

void SimulatedUnit::switch_off() noexcept {
  if (!instance_) return;
  instance_->power_off();
  leave();
}

void SimulatedUnit::leave() noexcept {
  tell([&](Judge& judge) { judge.on_power(*this, false); });
  instance_.reset();
  port_ = nullptr;
  link_ = nullptr;
  wake_ = write_ends_ = canopen::kNever;
}

void SimulatedUnit::set_link(bool up) noexcept {
  if (std::exchange(link_is_up_, up) == up || !instance_) return;
  port_->set_up(up);
  link_->change(up ? bus::LinkState::Up : bus::LinkState::Down);
  on_arrival();
}

void SimulatedUnit::set_error_state(bus::ErrorState state) noexcept {
  if (instance_) port_->set_error_state(state);
}

canopen::TimePoint SimulatedUnit::next_deadline() const noexcept {
  return wake_ == canopen::kNever ? wake_ : std::max(wake_, stalled_until_);
}

void SimulatedUnit::on_arrival() noexcept {
  wake_ = std::min(wake_, site_.time.now() + std::chrono::microseconds{draw_.between(kQuickest, kSlowest)});
}

/// After a turn: the next one.
void SimulatedUnit::plan_turn() noexcept {
  const canopen::TimePoint deadline = std::min(instance_->bus().next_deadline(), write_ends_);
  const bool waits = (port_->is_readable() && instance_->bus().descriptor() >= 0) || link_->is_readable();
  const canopen::TimePoint wanted = waits ? site_.time.now() : std::max(deadline, site_.time.now());
  wake_ =
      wanted == canopen::kNever ? wanted : wanted + std::chrono::microseconds{draw_.between(kQuickest, kSlowest)};
}

void SimulatedUnit::refresh() noexcept {
  if (!instance_) return;
  const canopen::TimePoint deadline = std::max(instance_->bus().next_deadline(), site_.time.now());
  if (deadline < wake_ - std::chrono::microseconds{kSlowest}) plan_turn();
}

void SimulatedUnit::turn() noexcept {
  const canopen::TimePoint now = site_.time.now();
  const std::uint64_t allocated = allocations.count;
  {
    const Counted counted;
    if (write_ends_ <= now) {
      write_ends_ = canopen::kNever;
      handle(Rare::WriteEnded);
    }
    if (link_->is_readable()) handle(Rare::Link);
    const bool readable = port_->is_readable() && instance_->bus().descriptor() >= 0;
    instance_->bus().turn(now, readable);
  }
  const std::uint64_t more = allocations.count - allocated;
  tell([&](Judge& judge) { judge.on_turn(*this, now, more); });
  if (!disk_.has_power()) return leave();
  note_writes();
  plan_turn();
}

void SimulatedUnit::handle(Rare source) noexcept {
  const auto& rare = instance_->rare_sources()[static_cast<std::size_t>(source)];
  (rare.instance->*rare.handle)();
  instance_->look_around();
}

/// The disk was written within the turn, and says so later.
void SimulatedUnit::note_writes() noexcept {
  if (std::exchange(operations_seen_, disk_.operations()) == disk_.operations()) return;
  write_ends_ = site_.time.now() + std::chrono::microseconds{draw_.between(kQuickestWrite, kSlowestWrite)};
}

void SimulatedUnit::on_taken(const canopen::Frame& frame) noexcept {
  tell([&](Judge& judge) { judge.on_taken(*this, frame, site_.time.now()); });
}

void SimulatedUnit::on_sent(const canopen::Frame& frame) noexcept {
  tell([&](Judge& judge) { judge.on_sent(*this, frame, site_.time.now()); });
}

void SimulatedUnit::on_event(const axisd::Instance&, const axisd::UnitEvent& event) noexcept {
  tell([&](Judge& judge) { judge.on_event(*this, event); });
}

void SimulatedUnit::on_step(long) noexcept {
  tell([&](Judge& judge) { judge.on_step(*this); });
}

void SimulatedUnit::on_cycle_end() noexcept {
  tell([&](Judge& judge) {
    judge.on_step(*this);
    judge.on_cycle(*this, site_.time.now());
  });
}

}  // namespace sim
