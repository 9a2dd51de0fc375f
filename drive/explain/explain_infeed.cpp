// Why an infeed does not operate.
#include <array>

#include <fmt/format.h>

#include "drive/explain/explain.hpp"
#include "drive/explain/explain_reasons.hpp"
#include "drive/infeed/infeed.hpp"

namespace drive {
namespace {

using explanation::order_for;
using explanation::plain;
using explanation::wiring_of;

/// A reason that an infeed does not operate in a state while it holds.
struct Reason {
  State state;
  bool (*holds)(const Infeed& infeed);
  std::string (*text)(const Infeed& infeed);
};

bool always(const Infeed&) noexcept {
  return true;
}

constexpr std::array kReasons{
    Reason{State::SwitchOnDisabled, [](const Infeed& infeed) { return infeed.inputs().has_off2(); },
           [](const Infeed& infeed) {
             const std::uint16_t input = infeed.inputs().no_off2 ? 845 : 844;
             return fmt::format("OFF2 of the infeed is given by {}: {}.", wiring_of(infeed, input),
                                order_for(infeed, input, true));
           }},
    Reason{State::SwitchOnDisabled, [](const Infeed& infeed) { return infeed.inputs().on; },
           [](const Infeed& infeed) {
             return fmt::format("ON of the infeed ({}) is still set and needs an edge: {}, then the contrary.",
                                wiring_of(infeed, 840), order_for(infeed, 840, false));
           }},
    Reason{State::ReadyToSwitchOn, always,
           [](const Infeed& infeed) {
             return fmt::format("The infeed (drive object {}) is off, its ON is missing ({}): {}.",
                                infeed.number(), wiring_of(infeed, 840), order_for(infeed, 840, true));
           }},
    Reason{State::SwitchedOn, [](const Infeed& infeed) { return !infeed.has_link(); },
           [](const Infeed& infeed) {
             return fmt::format(
                 "The infeed is on, but the DC link has {} V, less than {} V: switch the line on before p0857 "
                 "ends in F07802.",
                 plain(infeed.dc_voltage()), plain(infeed.context().supply.undervoltage));
           }},
    Reason{State::SwitchedOn, [](const Infeed& infeed) { return !infeed.inputs().enable_operation; },
           [](const Infeed& infeed) {
             return fmt::format("The operation enable of the infeed is missing ({}): {}.", wiring_of(infeed, 852),
                                order_for(infeed, 852, true));
           }},
};

}  // namespace

std::vector<std::string> explain(const Infeed& infeed) {
  std::vector<std::string> sentences;
  if (infeed.state() == State::Fault)
    for (const FaultEntry& fault : infeed.messages().faults())
      sentences.push_back(fmt::format(
          "The infeed has fault {} {} (value {}): remove its cause, acknowledge it (p2103 to p2105 or p3981 "
          "of drive object {}), then give ON anew.",
          fault_text(*fault.row), fault.row->name, fault.value, infeed.number()));
  for (const Reason& reason : kReasons)
    if (reason.state == infeed.state() && reason.holds(infeed)) sentences.push_back(reason.text(infeed));
  return sentences;
}

}  // namespace drive
