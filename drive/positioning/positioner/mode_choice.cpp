// Which mode of the basic positioner a request leads to.
#include <array>

#include "drive/positioning/positioner/positioner.hpp"

namespace drive {
namespace {

using Inputs = PositionerInputs;
constexpr std::uint8_t kMdiAndBlock = 5;  // value of A07457
constexpr std::uint32_t kNoEnable = 1;    // value of A07496: p2656
constexpr std::uint32_t kNoPosition = 2;  // p2658

/// A request of a slice and the signal that it comes by.
struct Request {
  ModeRequest request;
  bool Inputs::*signal;
  bool comes;
};

bool Inputs::*jog_signal(const ModeContext& context) noexcept {
  return context.rises(&Inputs::jog_1) ? &Inputs::jog_1 : &Inputs::jog_2;
}

}  // namespace

/// The signal that keeps the active mode, for the alarm of two that exclude each other.
bool Inputs::*Positioner::signal_of_mode() const noexcept {
  switch (mode()) {
    case PositionerMode::Jog:
      return inputs.jog_1 ? &Inputs::jog_1 : &Inputs::jog_2;
    case PositionerMode::Search:
      return &Inputs::reference;
    case PositionerMode::Mdi:
      return &Inputs::mdi;
    case PositionerMode::Blocks:
    case PositionerMode::Basic:
      break;
  }
  return nullptr;
}

/// Whether @p request may begin: the table of modes, then the enables.
bool Positioner::is_admitted(ModeContext& context, ModeRequest request, bool Inputs::*signal) noexcept {
  const ModeSwitch& becomes = switch_of(request, mode());
  if (becomes.kind == ModeSwitch::Kind::Ignore) return false;
  if (becomes.kind == ModeSwitch::Kind::Refuse) {
    const auto other = signal_of_mode();
    const bool is_held = other != nullptr && inputs.*other;  // else it brakes, or was started by an edge
    context.refusals.clash(becomes.alarm_value, signal, is_held ? other : signal, mode());
    return false;
  }
  if (enabled_) return true;
  context.refusals.refuse(PositioningMessage::EnableNotPossible, signal,
                          inputs.position_valid ? kNoEnable : kNoPosition);
  return false;
}

/// Whether a rising p2631 asks for a block; where p2650 rises with it, p2647 says whom the edge belongs to.
bool Positioner::block_is_requested(const ModeContext& context) const noexcept {
  const bool is_of_mdi = inputs.mdi && mode() != PositionerMode::Blocks && context.rises(&Inputs::mdi_transfer);
  return BlockMode::is_requested(context) && !is_of_mdi;
}

/// Whether MDI asks for its mode; not while a block runs, nor as long as what it came together with stands. What
/// has been waiting gives way to what is new.
bool Positioner::mdi_is_requested(const ModeContext& context) noexcept {
  const bool requested = mdi_.is_requested(context);
  const bool waits =
      inputs.mdi_continuous && !context.rises(&Inputs::mdi) && !context.rises(&Inputs::mdi_continuous);
  const bool gives_way = waits && (JogMode::is_requested(context) || ReferenceSearch::is_requested(context));
  return requested && mode() != PositionerMode::Mdi && mode() != PositionerMode::Blocks && !gives_way &&
         !refusals_.excludes(&Inputs::mdi, inputs);
}

void Positioner::choose_mode(ModeContext& context) noexcept {
  const bool mdi_requested = mdi_is_requested(context);
  const bool block_requested = block_is_requested(context);
  if (inputs.mdi && mode() == PositionerMode::Blocks)
    refusals_.clash(kMdiAndBlock, &Inputs::mdi, &Inputs::mdi, PositionerMode::Blocks);
  if (block_requested && inputs.mdi && mode() == PositionerMode::Basic)
    return refusals_.clash(kMdiAndBlock, &Inputs::mdi, &Inputs::activate_task);
  const std::array requests{
      Request{ModeRequest::Jog, jog_signal(context), JogMode::is_requested(context)},
      Request{ModeRequest::Search, &Inputs::reference, ReferenceSearch::is_requested(context)},
      Request{ModeRequest::Mdi, inputs.mdi_continuous ? &Inputs::mdi : &Inputs::mdi_transfer, mdi_requested},
      Request{ModeRequest::Block, &Inputs::activate_task, block_requested}};
  const Request* chosen = nullptr;
  for (const Request& request : requests) {
    if (!request.comes) continue;
    if (chosen != nullptr && mode() == PositionerMode::Basic)
      return context.refusals.clash(alarm_value(chosen->request, request.request), chosen->signal, request.signal);
    if (chosen == nullptr) chosen = &request;
    if (mode() != PositionerMode::Basic) begin(context, request.request, request.signal);
  }
  if (chosen != nullptr && mode() == PositionerMode::Basic) begin(context, chosen->request, chosen->signal);
}

void Positioner::begin(ModeContext& context, ModeRequest request, bool Inputs::*signal) noexcept {
  if (!is_admitted(context, request, signal)) {
    if (request == ModeRequest::Mdi) mdi_.stand_by(context);
    return;
  }
  if (request == ModeRequest::Mdi && !mdi_.may_start(context)) return;
  if (request == ModeRequest::Block && !BlockMode::may_start(context)) return;
  refusals_.accept();
  messages_.show(PositioningMessage::ChangeNotRequested, false);
  if (request == ModeRequest::Block) return blocks_.start(context);
  if (blocks_.fixed_stop().is_active()) blocks_.release(context);
  switch (request) {
    case ModeRequest::Jog:
      return jog_.start(context);
    case ModeRequest::Search:
      return search_.start(context);
    case ModeRequest::Mdi:
      return mdi_.start(context);
    case ModeRequest::Block:
      break;
  }
}

}  // namespace drive
