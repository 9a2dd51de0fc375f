// Why an axis does not turn, as far as SpeedControl knows.
#include <array>

#include <fmt/format.h>

#include "drive/explain/explain_reasons.hpp"

namespace drive {
namespace {

using namespace explanation;
using enum State;
using P = const Picture&;

constexpr States kOperation = in(State::OperationEnabled);

constexpr std::array kReasons{
    Reason{510, kOperation, [](P p) { return !p.control().inputs.enable; },
           [](P p) {
             return fmt::format("The speed controller is inhibited and gives no torque ({}): {}.",
                                wiring_of(p.axis, 856), order_for(p.axis, 856, true));
           }},
};

}  // namespace

std::span<const Reason> SpeedControl::reasons() noexcept {
  return kReasons;
}

}  // namespace drive
