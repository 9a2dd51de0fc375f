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
    context.refusals.clash(becomes.alarm_value, signal, other != nullptr ? other : signal);
    return false;
  }
  if (enabled_) return true;
  context.refusals.refuse(PositioningMessage::EnableNotPossible, signal,
                          inputs.position_valid ? kNoEnable : kNoPosition);
  return false;
}

void Positioner::choose_mode(ModeContext& context) noexcept {
  const bool for_mdi = inputs.mdi && mode() != PositionerMode::Blocks;
  const bool mdi_requested = mdi_.is_requested(context);
  if (inputs.mdi && mode() == PositionerMode::Blocks)
    context.refusals.clash(kMdiAndBlock, &Inputs::mdi, &Inputs::mdi);
  const bool edge_is_of_mdi = for_mdi && context.rises(&Inputs::mdi_transfer);
  const bool block_requested = BlockMode::is_requested(context) && !edge_is_of_mdi;
  if (block_requested && for_mdi)
    return context.refusals.clash(kMdiAndBlock, &Inputs::mdi, &Inputs::activate_task);
  const std::array requests{
      Request{ModeRequest::Jog, jog_signal(context), JogMode::is_requested(context)},
      Request{ModeRequest::Search, &Inputs::reference, ReferenceSearch::is_requested(context)},
      Request{ModeRequest::Mdi, inputs.mdi_continuous ? &Inputs::mdi : &Inputs::mdi_transfer,
              mdi_requested && mode() != PositionerMode::Mdi && mode() != PositionerMode::Blocks},
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
  const auto let_go = [&] {
    if (mode() == PositionerMode::Basic && blocks_.fixed_stop().is_active()) blocks_.release(context);
  };
  switch (request) {
    case ModeRequest::Jog:
      refusals_.accept();
      let_go();
      return jog_.start(context);
    case ModeRequest::Search:
      refusals_.accept();
      let_go();
      return search_.start(context);
    case ModeRequest::Mdi:
      if (!mdi_.may_start(context)) return;
      let_go();
      return mdi_.start(context);
    case ModeRequest::Block:
      if (blocks_.may_start(context)) blocks_.start(context);
      return;
  }
}

}  // namespace drive
