#include "farm/agent/plan/hubs.hpp"

#include <algorithm>

namespace farm::agent {

using canopen::TimePoint;

void Hubs::on_found(const std::string& bus, std::uint32_t bit_rate, TimePoint now) {
  Hub& hub = hubs_[bus];
  hub.bit_rate = bit_rate;
  hub.process.on_started(now);
}

void Hubs::on_started(const std::string& bus, TimePoint now) {
  if (Process& process = hubs_[bus].process; process.state() == Process::State::Starting) process.on_started(now);
}

void Hubs::on_ended(const std::string& bus, const std::string& why, TimePoint now) {
  hubs_[bus].process.on_ended(why, now);
}

void Hubs::advance(const std::map<std::string, std::uint32_t>& wanted, const std::set<std::string>& in_use,
                   TimePoint now, Orders& orders) {
  due_ = canopen::kNever;
  for (const auto& [bus, bit_rate] : wanted) {
    Hub& hub = hubs_[bus];
    if (hub.process.may_start(now)) {
      hub.bit_rate = bit_rate;
      hub.process.start();
      orders.hub_starts.push_back({bus, bit_rate});
    } else if (hub.process.state() == Process::State::On && hub.bit_rate != bit_rate) {
      hub.process.stop();
      orders.hub_stops.push_back(bus);
    }
    due_ = std::min(due_, hub.process.next_start());
  }
  for (auto& [bus, hub] : hubs_) {
    if (wanted.contains(bus) || in_use.contains(bus)) continue;
    if (hub.process.state() == Process::State::On) {
      hub.process.stop();
      orders.hub_stops.push_back(bus);
    }
  }
}

bool Hubs::is_on(const std::string& bus) const {
  const auto hub = hubs_.find(bus);
  return hub != hubs_.end() && hub->second.process.state() == Process::State::On;
}

std::string Hubs::problem(const std::string& bus) const {
  const auto hub = hubs_.find(bus);
  return hub == hubs_.end() ? std::string{} : hub->second.process.problem();
}

bool Hubs::are_off() const {
  return std::ranges::all_of(hubs_, [](const auto& each) { return each.second.process.is_off(); });
}

}  // namespace farm::agent
