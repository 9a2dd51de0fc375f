// Why an axis does not turn, as far as OperatorPanel knows.
#include <array>

#include <fmt/format.h>

#include "drive/explain/explain_reasons.hpp"

namespace drive {
namespace {

using namespace explanation;
using P = const Picture&;

constexpr States kAll = (1U << kStateCount) - 1U;

const OperatorPanel& panel_of(P p) noexcept {
  return p.axis.block<OperatorPanel>();
}

constexpr std::array kReasons{
    Reason{
        110, kAll, [](P p) { return panel_of(p).is_active() && !panel_of(p).returns(); },
        [](P p) {
          return fmt::format(
              "The control is with an operator panel (r0807 = 1), for {} s unless it says more: command the axis "
              "there, or give the control back.",
              plain(panel_of(p).remaining()));
        }},
    Reason{110, kAll, [](P p) { return panel_of(p).returns(); },
           [](P) -> std::string {
             return "The operator panel has fallen silent or given the control back (r0807 = 1): the control goes "
                    "back at standstill.";
           }},
};

}  // namespace

std::span<const Reason> OperatorPanel::reasons() noexcept {
  return kReasons;
}

}  // namespace drive
