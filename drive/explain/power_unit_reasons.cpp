// Why an axis does not turn, as far as PowerUnit knows.
#include <array>

#include <fmt/format.h>

#include "drive/explain/explain_reasons.hpp"

namespace drive {
namespace {

using namespace explanation;
using enum State;
using P = const Picture&;

bool has_dc_link(P p) noexcept {
  return p.axis.block<PowerUnit>().has_link();
}

constexpr std::array kReasons{
    Reason{250, in(SwitchedOn), [](P p) { return !has_dc_link(p); },
           [](P p) {
             return fmt::format(
                 "The DC link has {} V, less than {} V: switch the line on before p0857 ends in F07802.",
                 plain(p.axis.block<PowerUnit>().dc_voltage()), plain(p.axis.context().supply.undervoltage));
           }},
};

}  // namespace

std::span<const Reason> PowerUnit::reasons() noexcept {
  return kReasons;
}

}  // namespace drive
