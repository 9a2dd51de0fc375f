#pragma once

#include <string>
#include <string_view>

#include "can/hub/faults/faults.hpp"
#include "tests/can/hub/told.hpp"

namespace faulty {

using told::kStart;
using namespace std::chrono_literals;
using Texts = std::vector<std::string>;

/// A wire with three participants, and its faults.
struct Bus {
  explicit Bus(std::uint32_t bit_rate = 0) : medium{bit_rate} {
    for (told::Listener* each : {&a, &b, &c}) medium.attach(*each);
  }

  /// The number of the fault, or what is wrong with it.
  std::string inject(std::string_view words) {
    const auto number = faults.inject(nlohmann::json(words), now);
    return number ? std::to_string(*number) : number.error();
  }
  void send(told::Listener& sender, std::string_view text) { medium.send(told::passage(sender, text), now); }
  /// Lets @p time go by, and the medium do at each moment what it wants to.
  void wait(canopen::Duration time) {
    const canopen::TimePoint end = now + time;
    while (medium.next_deadline() <= end) {
      now = std::max(now, medium.next_deadline());
      medium.on_time(now);
    }
    now = end;
  }
  /// What has come of fault @p place (from 0): "over 3 of 7".
  std::string told(std::size_t place = 0) {
    const nlohmann::json row = faults.list(now).at(place);
    return row.at("state").get<std::string>() + ' ' + row.at("hits").dump() + " of " +
           row.at("opportunities").dump();
  }

  canopen::TimePoint now = kStart;
  hub::Medium medium;
  hub::Interfaces interfaces;
  told::Listener a, b, c;
  hub::faults::Faults faults{medium, interfaces};
};

}  // namespace faulty
