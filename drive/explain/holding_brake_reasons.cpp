// Why an axis does not turn, as far as HoldingBrake knows.
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
    Reason{500, kOperation, [](P p) { return p.axis.brake_opens(); },
           [](P) -> std::string { return "The holding brake opens (r0002 = 15): wait for its opening time."; }},
};

}  // namespace

std::span<const Reason> HoldingBrake::reasons() noexcept {
  return kReasons;
}

}  // namespace drive
