#include "injection/wire/kinds.hpp"

#include <array>
#include <cstddef>
#include <string_view>

#include "injection/kinds/unit_kinds.hpp"
#include "injection/wire/actions.hpp"

namespace injection {
namespace {

namespace a = actions;

/// What a kind does, in the order of unit_kinds().
struct Row {
  std::string_view name;
  WireKind wire;
};

constexpr std::array kRows{
    Row{"sdo.deaf", {a::fits_transfer, a::drop}},
    Row{"sdo.silent", {a::fits_transfer, a::drop}},
    Row{"sdo.late", {a::fits_transfer, a::delay}},
    Row{"sdo.twice", {a::fits_transfer, a::double_it}},
    Row{"sdo.abort", {a::fits_request, a::abort}},
    Row{"sdo.toggle", {a::fits_segment, a::flip_toggle}},
    Row{"sdo.multiplexor", {a::fits_initiation, a::change_multiplexor}},
    Row{"sdo.length", {a::fits_size, a::change_size}},
    Row{"sdo.crc", {a::fits_crc, a::change_crc}},
    Row{"sdo.sequence", {a::fits_sequence, a::change_sequence}},
    Row{"tpdo.swallow", {a::fits_pdo, a::drop}},
    Row{"tpdo.late", {a::fits_pdo, a::delay}},
    Row{"tpdo.twice", {a::fits_pdo, a::double_it}},
    Row{"tpdo.short", {a::fits_pdo, a::shorten}},
    Row{"tpdo.frozen", {a::fits_pdo, a::freeze}},
    Row{"tpdo.swap", {a::fits_pdo, a::swap_values}},
    Row{"rpdo.deaf", {a::fits_pdo, a::drop}},
    Row{"sync.deaf", {a::fits_received, a::drop}},
    Row{"nmt.deaf", {a::fits_received, a::drop}},
    Row{"heartbeat.gap", {a::fits_sent, a::drop}},
    Row{"heartbeat.late", {a::fits_sent, a::delay}},
    Row{"heartbeat.state", {a::fits_sent, a::change_state}},
    Row{"guard.silent", {a::fits_sent, a::drop}},
    Row{"guard.toggle", {a::fits_sent, a::flip_guard_toggle}},
    Row{"boot-up.missing", {a::fits_sent, a::drop}},
    Row{"boot-up.late", {a::fits_sent, a::delay}},
    Row{"boot-up.twice", {a::fits_sent, a::double_it}},
    Row{"emcy.missing", {a::fits_sent, a::drop}},
    Row{"emcy.never-cleared", {a::fits_end_of_emergency, a::drop}},
    Row{"emcy.storm", {.doing = Doing::Storm}},
    Row{"drive.frozen", {}},
    Row{"drive.ignores-controlword", {}},
    Row{"drive.status-bit", {}},
    Row{"drive.never", {}},
    Row{"node.reset", {.doing = Doing::Reset}},
    Row{"node.id", {.doing = Doing::NodeId}},
    Row{"node.gone", {.doing = Doing::Gone}},
    Row{"controller.passive", {.doing = Doing::Passive}},
    Row{"controller.off", {.doing = Doing::BusOff}},
};

constexpr bool is_in_order() noexcept {
  for (std::size_t i = 0; i < kRows.size(); ++i)
    if (kRows[i].name != unit_kinds()[i].name) return false;
  return kRows.size() == unit_kinds().size();
}
static_assert(is_in_order());

/// By their places among the words of Argument::DriveState.
constexpr std::array kHindrances{
    Hindrance{.cleared = 0x0080},  // switch-on-disabled: faults are not acknowledged
    Hindrance{.cleared = 0x0006},  // ready-to-switch-on
    Hindrance{.cleared = 0x0001},  // switched-on
    Hindrance{.cleared = 0x0008},  // operation-enabled
    Hindrance{.set = 0x0004},      // quick-stop-active
};

}  // namespace

const WireKind& wire_kind(const Kind& kind) noexcept {
  return kRows[static_cast<std::size_t>(&kind - unit_kinds().data())].wire;
}

Hindrance hindrance_of(std::uint32_t state) noexcept {
  return kHindrances[state];
}

}  // namespace injection
