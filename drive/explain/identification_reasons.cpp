// Why an axis does not turn, as far as Identification knows.
#include <array>

#include <fmt/format.h>

#include "drive/explain/explain_reasons.hpp"

namespace drive {
namespace {

using namespace explanation;
using enum State;
using P = const Picture&;

constexpr std::array kReasons{
    Reason{150, in(SwitchOnDisabled, ReadyToSwitchOn, SwitchedOn),
           [](P p) { return p.axis.identification().due() != IdentificationPart::None; },
           [](P p) {
             const bool stands = p.axis.identification().due() == IdentificationPart::Standstill;
             return fmt::format("{} is selected: the next ON measures the motor {}; write 0 to take it back.",
                                stands ? "p1910 (A07991)" : "p1960 (A07980)",
                                stands ? "at standstill" : "turning, up to p1082");
           }},
};

}  // namespace

std::span<const Reason> Identification::reasons() noexcept {
  return kReasons;
}

}  // namespace drive
