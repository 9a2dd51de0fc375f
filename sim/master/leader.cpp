#include "sim/master/leader.hpp"

#include <array>
#include <chrono>

#include "libcanopen/base/cob_id.hpp"

namespace sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr std::uint8_t kStart = 0x01, kStop = 0x02, kEnterPreOperational = 0x80, kResetNode = 0x81,
                       kResetCommunication = 0x82;
constexpr std::uint16_t kControlword = 0x6040, kStatusword = 0x6041, kMode = 0x6060, kTargetVelocity = 0x60FF;
constexpr std::uint16_t kAxisStride = 0x800;
constexpr std::uint16_t kShutdown = 0x06, kSwitchOn = 0x07, kEnableOperation = 0x0F, kFaultReset = 0x80;
constexpr std::uint16_t kStateMask = 0x6F, kShortStateMask = 0x4F;
constexpr std::uint16_t kReady = 0x21, kSwitchedOn = 0x23, kEnabled = 0x27, kFault = 0x08, kFaultReaction = 0x0F;
constexpr std::uint8_t kProfileVelocity = 3;
constexpr std::uint32_t kSave = 0x65766173, kLoad = 0x64616F6C;
constexpr std::uint32_t kRpdo2 = 0x300;
constexpr std::uint16_t kTpdo2 = 0x1801;
constexpr std::uint32_t kInvalid = 0x8000'0000;

/// A revolution has 4 194 304 increments; some turns a second, either way.
constexpr std::int64_t kFastest = 40LL * 4'194'304;
/// Time for a node to follow an NMT command, and to answer the first request.
constexpr canopen::Duration kNmtTime = milliseconds{20}, kFirstAnswer = milliseconds{300};
/// Time for one step of the state machine: the motor may have to be magnetised, the brake to open.
constexpr canopen::Duration kStepTime = seconds{3};

}  // namespace

Leader::Leader(hub::Medium& medium, std::string_view name, const LeaderPlan& plan, canopen::TimePoint calm)
    : Station{medium, name, Draw{plan.seed}}, plan_{plan}, calm_{calm}, sdo_{*this, plan.node_id}, task_{lead()} {
  task_.start();
}

void Leader::on_frame(const canopen::Frame& frame) noexcept {
  if (frame.id != canopen::function_code::kErrorControl + plan_.node_id || frame.remote || frame.length != 1)
    return;
  heard_ = now();
  if (frame.data[0] == 0) has_restarted_ = true;
}

/// It has booted behind the leader's back, or its heartbeat is missing.
bool Leader::is_lost() const noexcept {
  const bool is_silent = consumes_heartbeat_ && now() - heard_ > 4 * milliseconds{plan_.heartbeat_ms};
  return has_restarted_ || is_silent;
}

std::uint16_t Leader::object(std::uint16_t index, unsigned axis) noexcept {
  return static_cast<std::uint16_t>(index + kAxisStride * axis);
}

void Leader::command_node(std::uint8_t command) noexcept {
  send({.id = 0, .length = 2, .data = {command, plan_.node_id}});
}

Task<Done> Leader::lead() {
  while (true) {
    consumes_heartbeat_ = false;
    const bool is_enabled = co_await prepare();
    if (is_enabled)
      co_await work();
    else
      co_await sleep(milliseconds{draw().between(20, 200)});
  }
}

/// From whatever the unit is in to Operation enabled on all axes.
Task<bool> Leader::prepare() {
  const bool is_there = co_await greet();
  if (!is_there) co_return false;
  const bool is_configured = co_await configure();
  if (!is_configured) co_return false;
  for (unsigned axis = 0; axis < plan_.axes; ++axis) {
    const bool is_enabled = co_await enable(axis);
    if (!is_enabled) co_return false;
  }
  co_return true;
}

/// Until an axis is not enabled any more, be it by the leader itself.
Task<Done> Leader::work() {
  while (true) {
    const bool has_stayed = co_await stay();
    if (!has_stayed) co_return Done{};
    if (is_calm()) continue;
    const bool goes_on = co_await act();
    if (!goes_on) co_return Done{};
  }
}

/// Whether it is there. A node that is silent may be in Stopped.
Task<bool> Leader::greet() {
  has_restarted_ = false;
  bool is_there = co_await answers();
  if (!is_there) {
    command_node(kEnterPreOperational);
    co_await sleep(kNmtTime);
    is_there = co_await answers();
  }
  co_return is_there;
}

/// Whether its device type can be read.
Task<bool> Leader::answers() {
  const auto type = co_await sdo_.read({0x1000}, kFirstAnswer);
  co_return type.has_value();
}

Task<bool> Leader::configure() {
  command_node(kEnterPreOperational);
  co_await sleep(kNmtTime);
  const auto heartbeat = co_await sdo_.write({0x1017}, plan_.heartbeat_ms, 2);
  if (!heartbeat) co_return false;
  const bool has_pdo = co_await configure_pdo();
  // A frame that was damaged may have put a COB-ID into another PDO: what was not saved is gone then.
  if (!has_pdo && is_calm()) command_node(kResetCommunication);
  if (!has_pdo) co_return false;
  command_node(kStart);
  co_await sleep(kNmtTime);
  heard_ = now();
  consumes_heartbeat_ = plan_.heartbeat_ms != 0;
  co_return !is_lost();
}

Task<bool> Leader::configure_pdo() {
  struct Setting {
    std::uint8_t sub_index;
    std::uint32_t value;
    std::size_t size;
  };
  const std::uint32_t own = 0x4000'0280U + plan_.node_id;
  const std::array<Setting, 4> settings{
      {{1, own | kInvalid, 4}, {2, plan_.transmission, 1}, {3, plan_.inhibit_100us, 2}, {1, own, 4}}};
  for (const Setting& each : settings) {
    const auto written = co_await sdo_.write({kTpdo2, each.sub_index}, each.value, each.size);
    if (!written) co_return false;
  }
  co_return true;
}

Task<std::optional<std::uint16_t>> Leader::statusword(unsigned axis) {
  const auto read = co_await sdo_.read({object(kStatusword, axis)});
  if (!read || read->size() != 2 || is_lost()) co_return std::optional<std::uint16_t>{};
  co_return std::optional{static_cast<std::uint16_t>((*read)[0] | (*read)[1] << 8U)};
}

Task<bool> Leader::command(unsigned axis, std::uint16_t controlword) {
  if (axis == 0 && plan_.by_rpdo && !plan_.is_cia402) {
    const auto target = static_cast<std::uint32_t>(target_);
    canopen::Frame rpdo{.id = kRpdo2 + plan_.node_id, .length = 6};
    rpdo.data[0] = static_cast<std::uint8_t>(controlword & 0xFF);
    rpdo.data[1] = static_cast<std::uint8_t>(controlword >> 8U);
    for (unsigned i = 0; i < 4; ++i) rpdo.data[2 + i] = static_cast<std::uint8_t>(target >> 8U * i & 0xFFU);
    send(rpdo);
    co_await sleep(milliseconds{12});
    co_return !is_lost();
  }
  const auto written = co_await sdo_.write({object(kControlword, axis)}, controlword, 2);
  co_await sleep(milliseconds{12});
  co_return written.has_value() && !is_lost();
}

Task<bool> Leader::enable(unsigned axis) {
  auto status = co_await statusword(axis);
  if (!status) co_return false;
  if ((*status & kStateMask) == kEnabled) co_return true;
  if ((*status & kShortStateMask) == kFault || (*status & kShortStateMask) == kFaultReaction) {
    const bool is_reset = co_await reset_fault(axis);
    if (!is_reset) co_return false;
  }
  if (plan_.is_cia402) {
    const auto mode = co_await sdo_.write({object(kMode, axis)}, kProfileVelocity, 1);
    if (!mode) co_return false;
  }
  constexpr std::array<std::array<std::uint16_t, 2>, 3> kSteps{
      {{kShutdown, kReady}, {kSwitchOn, kSwitchedOn}, {kEnableOperation, kEnabled}}};
  for (const auto& [controlword, state] : kSteps) {
    const bool is_there = co_await bring_to(axis, controlword, state);
    if (!is_there) co_return false;
  }
  co_return true;
}

Task<bool> Leader::reset_fault(unsigned axis) {
  constexpr std::array<std::uint16_t, 3> kWords{0, kFaultReset, 0};
  for (const std::uint16_t word : kWords) {
    const bool is_heard = co_await command(axis, word);
    if (!is_heard) co_return false;
  }
  const auto status = co_await statusword(axis);
  co_return status && (*status & kShortStateMask) != kFault;
}

Task<bool> Leader::bring_to(unsigned axis, std::uint16_t controlword, std::uint16_t state) {
  const canopen::TimePoint end = now() + kStepTime;
  const bool is_heard = co_await command(axis, controlword);
  if (!is_heard) co_return false;
  while (now() < end) {
    const auto status = co_await statusword(axis);
    if (!status || (*status & kShortStateMask) == kFault) co_return false;
    if ((*status & kStateMask) == state) co_return true;
    co_await sleep(milliseconds{20});
  }
  co_return false;
}

/// For a while, as long as all axes stay enabled.
Task<bool> Leader::stay() {
  const canopen::TimePoint end = now() + milliseconds{draw().between(50, 500)};
  while (now() < end) {
    for (unsigned axis = 0; axis < plan_.axes; ++axis) {
      const auto status = co_await statusword(axis);
      if (!status || (*status & kStateMask) != kEnabled) co_return false;
    }
    co_await sleep(milliseconds{50});
  }
  co_return true;
}

Task<bool> Leader::act() {
  enum : std::uint8_t { Move, MoveAgain, Stop, Store, Read, Restart, kActs };
  const auto what = draw().below(kActs);
  bool goes_on = true;
  if (what == Stop) {
    goes_on = co_await stop();
  } else if (what == Store && plan_.stores) {
    goes_on = co_await store();
  } else if (what == Read) {
    goes_on = co_await read_around();
  } else if (what == Restart && plan_.restarts) {
    goes_on = co_await restart();
  } else {
    goes_on = co_await move();
  }
  co_return goes_on;
}

Task<bool> Leader::move() {
  const auto axis = static_cast<unsigned>(draw().below(plan_.axes));
  const auto target = static_cast<std::int32_t>(draw().between(-kFastest, kFastest));
  if (axis == 0) target_ = target;
  if (axis == 0 && plan_.by_rpdo && !plan_.is_cia402) {
    const bool is_heard = co_await command(axis, kEnableOperation);
    co_return is_heard;
  }
  const auto written = co_await sdo_.write({object(kTargetVelocity, axis)}, static_cast<std::uint32_t>(target), 4);
  co_return written.has_value();
}

/// Ends with false: the axis is to be enabled anew.
Task<bool> Leader::stop() {
  constexpr std::array<std::uint16_t, 3> kStops{kShutdown, 0x00, 0x02};  // OFF1, OFF2, quick stop
  const auto axis = static_cast<unsigned>(draw().below(plan_.axes));
  if (axis == 0) target_ = 0;
  co_await command(axis, draw().one_of(kStops));
  co_await sleep(milliseconds{draw().between(10, 1500)});
  co_return false;
}

/// Storing takes its time, and may be refused.
Task<bool> Leader::store() {
  const bool restores = draw().chance(0.2);
  co_await sdo_.write({static_cast<std::uint16_t>(restores ? 0x1011 : 0x1010), 1}, restores ? kLoad : kSave, 4,
                      seconds{5});
  co_return true;
}

Task<bool> Leader::read_around() {
  constexpr std::array<SdoObject, 6> kObjects{{{0x1008}, {0x100A}, {0x1018, 4}, {0x1003}, {0x1F80}, {0x6502}}};
  for (int i = 0; i < 4; ++i) co_await sdo_.read(draw().one_of(kObjects));
  co_return true;
}

Task<bool> Leader::restart() {
  constexpr std::array<std::uint8_t, 4> kCommands{kStop, kEnterPreOperational, kResetNode, kResetCommunication};
  command_node(draw().one_of(kCommands));
  co_await sleep(milliseconds{draw().between(5, 800)});
  co_return false;
}

}  // namespace sim
