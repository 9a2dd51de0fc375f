#include "drive/explain/explain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "drive/base/units.hpp"
#include "drive/catalogue/table.hpp"
#include "drive/explain/explain_reasons.hpp"
#include "drive/parameter/bico_text.hpp"

namespace drive {
namespace explanation {
namespace {

/// r8890 to r8893 are the bits of the first four words that are received.
constexpr std::uint16_t kFirstReceivedBits = 8890;
constexpr std::uint16_t kLastReceivedBits = 8893;
/// The same of IF1.
constexpr std::uint16_t kFirstIf1Bits = 2090;
constexpr std::uint16_t kLastIf1Bits = 2093;
constexpr std::uint16_t kDigitalInputs = 722;

std::uint32_t value_of(const DriveObject& object, std::uint16_t input) {
  return static_cast<std::uint32_t>(object.read(input).value_or(0.0));
}

bool is_own(const DriveObject& object, const BicoSource& source) noexcept {
  return source.object == kOwnObject || source.object == object.number();
}

std::string source_text(const DriveObject& object, std::uint16_t input, const BicoSource& source) {
  const PlacedRow* const placed = find_parameter(object.kind(), input);
  return bico_text(source, placed != nullptr ? placed->row->type : DataType::ConnectorInput, object.number());
}

}  // namespace

std::string wiring_of(const DriveObject& object, std::uint16_t input) {
  const std::uint32_t packed = value_of(object, input);
  if (packed <= kHighestConstant) return fmt::format("p{:04} = {}", input, packed);
  return fmt::format("p{:04} = {}", input, source_text(object, input, unpack(packed)));
}

std::string order_for(const DriveObject& object, std::uint16_t input, bool wanted) {
  const std::uint32_t packed = value_of(object, input);
  if (packed <= kHighestConstant) return fmt::format("write p{:04} = {} or connect it", input, wanted ? 1 : 0);
  const BicoSource source = unpack(packed);
  const bool received = source.number >= kFirstReceivedBits && source.number <= kLastReceivedBits;
  if (source.number >= kFirstIf1Bits && source.number <= kLastIf1Bits)
    return fmt::format("send word {} on IF1 with bit {} = {}{}", source.number - kFirstIf1Bits + 1,
                       source.position, wanted ? 1 : 0,
                       is_own(object, source) ? "" : fmt::format(" to drive object {}", source.object));
  if (received)
    return fmt::format("send a controlword with bit {} = {}{}", source.position, wanted ? 1 : 0,
                       is_own(object, source) ? "" : fmt::format(" to drive object {}", source.object));
  if (source.number == kDigitalInputs && source.object == kControlUnitNumber)
    return fmt::format("switch digital input {} {}", source.position, wanted ? "on" : "off");
  return fmt::format("make {} {}", source_text(object, input, source), wanted ? 1 : 0);
}

std::string commanded_by(const Axis& axis, std::uint16_t input) {
  return axis.block<OperatorPanel>().is_active() ? "by the operator panel" : wiring_of(axis, input);
}

std::string order_to(const Axis& axis, std::uint16_t input, bool wanted) {
  if (!axis.block<OperatorPanel>().is_active()) return order_for(axis, input, wanted);
  return fmt::format("switch it {} at the panel", wanted ? "on" : "off");
}

bool load_drives(const Picture& picture) noexcept {
  return std::abs(picture.axis.actual().speed) > kSlowest && picture.axis.drive_train().energies().load < 0.0;
}

std::string plain(double number) {
  return fmt::format("{:g}", std::round(number * 1000.0) / 1000.0);
}

namespace {

constexpr double kNoTorque = 1e-9;  // N·m

/// That the torque limits alone block the motor, if they do.
std::string torque_limit_hint(const Picture& picture) {
  const motor::TorqueLimits limits = picture.axis.effective_torque_limits();
  const bool forward = limits.upper > kNoTorque;
  const bool backward = limits.lower < -kNoTorque;
  if (forward && backward) return {};
  return fmt::format(
      " The torque limits leave no torque{} ({} to {} N·m; p1520 = {}, p1521 = {}): widen them first.",
      forward    ? " in the negative direction"
      : backward ? " in the positive direction"
                 : "",
      plain(limits.lower), plain(limits.upper), plain(picture.axis.read(1520).value_or(0.0)),
      plain(picture.axis.read(1521).value_or(0.0)));
}

/// What else there is to say of a fault, which would come again.
struct Hint {
  std::uint16_t fault;
  std::string (*text)(const Picture& picture);
};
constexpr std::array kHints{Hint{7900, torque_limit_hint}};

std::string hint_of(const FaultEntry& fault, const Picture& picture) {
  const auto* const row = std::ranges::find(kHints, fault.row->number, &Hint::fault);
  return row != kHints.end() ? row->text(picture) : std::string{};
}

std::string fault_sentence(const FaultEntry& fault) {
  const std::string name = fmt::format("{} {} (value {})", fault_text(*fault.row), fault.row->name, fault.value);
  if (fault.acknowledge() == Acknowledge::PowerOn)
    return fmt::format("Fault {}: it leaves only when the unit is switched off and on.", name);
  if (fault.acknowledged)
    return fmt::format("Fault {}: it is acknowledged and leaves with its cause ({}).", name, fault.row->cause);
  if (fault.cause != Cause::Gone)
    return fmt::format("Fault {}: its cause is still there ({}); remove it, then acknowledge.", name,
                       fault.row->cause);
  return fmt::format(
      "Fault {}: it can be acknowledged, by bit 7 of the controlword from 0 to 1; then give ON anew "
      "(0006h, 000Fh).",
      name);
}

void tell_faults(const Picture& picture, std::vector<std::string>& sentences) {
  constexpr States kStopped = in(State::Fault, State::FaultReactionActive, State::Stop2Active);
  if ((kStopped & in(picture.state())) == 0) return;
  for (const FaultEntry& fault : picture.axis.messages().faults())
    sentences.push_back(fault_sentence(fault) + hint_of(fault, picture));
}

/// What the blocks of the axis have to say, the most important first.
template <class... Block>
std::vector<const Reason*> all_reasons(const std::tuple<Block...>*) {
  std::vector<const Reason*> all;
  const auto append = [&]<class Owner>(const Owner*) {
    if constexpr (requires { Owner::reasons(); })
      for (const Reason& reason : Owner::reasons()) all.push_back(&reason);
  };
  (append(static_cast<const Block*>(nullptr)), ...);
  std::ranges::sort(all, {}, &Reason::rank);
  return all;
}

void tell_reasons(const Picture& picture, std::vector<std::string>& sentences) {
  for (const Reason* const reason : all_reasons(static_cast<const AxisBlocks*>(nullptr)))
    if ((reason->states & in(picture.state())) != 0 && reason->holds(picture))
      sentences.push_back(reason->text(picture));
}

std::string motion_sentence(const Picture& picture) {
  const double rpm = picture.axis.actual().speed / kRpm;
  const std::string what = picture.control().torque_control()
                               ? fmt::format("torque {} N·m", plain(picture.axis.actual().torque))
                               : fmt::format("setpoint {} rpm", plain(picture.axis.actual().speed_demand / kRpm));
  const std::string limit = !picture.axis.is_at_torque_limit() ? ""
                            : load_drives(picture)             ? "; the load drives it against its torque limit"
                                                               : "; it is at its torque limit";
  const char* const leader = picture.axis.block<OperatorPanel>().is_active() ? "; an operator panel leads it" : "";
  return fmt::format("It turns at {} rpm ({}{}{}{}).", plain(rpm), what, limit, positioning_text(picture), leader);
}

std::string measurement_sentence(const Axis& axis) {
  const Identification& identification = axis.identification();
  if (identification.waits())
    return "The motor identification waits until the holding brake is open and the shaft stands (r0002 = 14).";
  return fmt::format(
      "The motor is being measured by {} (r0002 = 14, r0047 = {}): wait for its end, or give OFF1 (0006h).",
      identification.running() == IdentificationPart::Standstill ? "p1910" : "p1960", identification.progress());
}

}  // namespace
}  // namespace explanation

bool turns(const Axis& axis) noexcept {
  return axis.actual().state == State::OperationEnabled && std::abs(axis.actual().speed) > explanation::kSlowest;
}

std::vector<std::string> explain(const Axis& axis, const std::vector<std::string>& bus) {
  using namespace explanation;
  const Picture picture{axis};
  std::vector<std::string> sentences;
  if (axis.identification().leads()) return {measurement_sentence(axis)};
  if (turns(axis)) return {motion_sentence(picture)};
  tell_faults(picture, sentences);
  sentences.insert(sentences.end(), bus.begin(), bus.end());
  tell_reasons(picture, sentences);
  if (sentences.empty())
    sentences.push_back(
        fmt::format("Nothing is missing (r0002 = {:.0f}, r0046 = {:08X}h); wait a cycle and ask again.",
                    axis.read(2).value_or(0.0), static_cast<std::uint32_t>(axis.read(46).value_or(0.0))));
  return sentences;
}

}  // namespace drive
