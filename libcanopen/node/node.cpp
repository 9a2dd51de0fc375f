#include "libcanopen/node/node.hpp"

#include <algorithm>

#include "libcanopen/base/cob_id.hpp"

namespace canopen {
namespace {

/// Numbers of the node's timers in its queue: the TPDOs take all that follow.
enum TimerNumber : std::size_t { kHeartbeatTimer, kSdoTimer, kFirstTpdoTimer };

constexpr std::uint16_t kFirstCommunicationObject = 0x1000;
constexpr std::uint16_t kLastCommunicationObject = 0x1FFF;
constexpr std::uint16_t kFirstApplicationObject = 0x2000;
constexpr std::uint16_t kLastApplicationObject = 0x9FFF;

/// Which state a command leads to; the reset commands are handled before.
struct CommandRow {
  NmtCommand command;
  NmtState state;
};
constexpr std::array kStateCommands{
    CommandRow{NmtCommand::Start, NmtState::Operational},
    CommandRow{NmtCommand::Stop, NmtState::Stopped},
    CommandRow{NmtCommand::EnterPreOperational, NmtState::PreOperational},
};

}  // namespace

Node::Node(Dictionary& dictionary, const Policy& policy, FrameSink& sink, Application& application)
    : policy_{policy},
      application_{application},
      timers_{kFirstTpdoTimer + TransmitPdos::timers_for(dictionary)},
      context_{.sink = sink, .dictionary = dictionary, .timers = timers_},
      heartbeat_{context_, kHeartbeatTimer},
      receive_pdos_{context_, policy_, *this, *this},
      transmit_pdos_{context_, policy_, *this, kFirstTpdoTimer},
      sync_{context_, *this},
      emcy_{context_, *this} {
  sdo_servers_.emplace_back(context_, policy_, function_code::kSdoResponse + dictionary.node_id(), kSdoTimer);
  subscriptions_.reserve(receive_pdos_.pdos().size() + sdo_servers_.size() + 4);
}

void Node::start(TimePoint now) noexcept {
  context_.now = now;
  boot();
}

void Node::on_frame(const Frame& frame, TimePoint now) noexcept {
  if (context_.state == NmtState::Initialising) return;  // a write to the dictionary may have laid routes already
  if (frame.extended || frame.remote || frame.id >= routes_.size()) return;
  context_.now = now;
  const Route route = routes_[frame.id];
  switch (route.service) {
    case Service::Sdo:
      if (gate_.sdo) sdo_servers_[route.position].on_frame(frame);
      break;
    case Service::Rpdo:
      if (gate_.pdo) receive_pdos_.on_frame(route.position, frame);
      break;
    case Service::Sync:
      if (gate_.sync && frame.length <= 1) on_sync();  // with or without a counter
      break;
    case Service::Nmt:
      on_nmt(frame);
      break;
    case Service::Own:
      application_.on_foreign_frame(frame.id);
      break;
    case Service::None:
      break;
  }
}

void Node::on_time(TimePoint now) noexcept {
  context_.now = now;
  if (context_.state == NmtState::Initialising) return;
  while (const auto timer = timers_.take_due(now)) on_timer(*timer);
}

void Node::on_timer(std::size_t timer) noexcept {
  switch (timer) {
    case kHeartbeatTimer:
      heartbeat_.on_timer();
      break;
    case kSdoTimer:
      sdo_servers_.front().on_timer();
      break;
    default:
      transmit_pdos_.on_timer(timer - kFirstTpdoTimer);
  }
}

void Node::on_values_changed(TimePoint now) noexcept {
  context_.now = now;
  transmit_pdos_.on_values_changed();
}

void Node::on_nmt(const Frame& frame) noexcept {
  if (frame.length != 2 || (frame.data[1] != 0 && frame.data[1] != node_id())) return;
  command(static_cast<NmtCommand>(frame.data[0]));
}

void Node::command(NmtCommand command) noexcept {
  if (command == NmtCommand::ResetNode || command == NmtCommand::ResetCommunication) return reset(command);
  const auto row = std::find_if(kStateCommands.begin(), kStateCommands.end(),
                                [=](const CommandRow& r) { return r.command == command; });
  if (row != kStateCommands.end()) {
    enter(row->state);
  } else if (policy_.unknown_command == UnknownCommand::Stop) {
    enter(NmtState::Stopped);
  }
}

void Node::reset(NmtCommand command) noexcept {
  enter(NmtState::Initialising);
  context_.dictionary.restore(kFirstCommunicationObject, kLastCommunicationObject);
  if (command == NmtCommand::ResetNode) {
    context_.dictionary.restore(kFirstApplicationObject, kLastApplicationObject);
  }
  application_.on_reset(command);
  boot();
}

void Node::boot() noexcept {
  for (SdoServer& server : sdo_servers_) server.forget();
  receive_pdos_.reload();
  transmit_pdos_.reload();
  sync_.reload();
  emcy_.reload();
  on_identifiers_changed();
  context_.sink.send(Frame{.id = function_code::kErrorControl + node_id(), .length = 1}, Delivery::Ordered);
  heartbeat_.reload();
  enter(policy_.start_state);
}

void Node::enter(NmtState state) noexcept {
  const NmtState from = context_.state;
  if (state == from) return;
  context_.state = state;
  gate_ = services_in(state);
  if (from == NmtState::Operational) {
    receive_pdos_.forget();
    transmit_pdos_.stop();
  }
  if (!gate_.sdo) {
    for (SdoServer& server : sdo_servers_) server.forget();
  }
  application_.on_nmt_state(from, state);
  if (state == NmtState::Operational) transmit_pdos_.start();
}

void Node::on_sync() noexcept {
  if (!gate_.pdo) return;
  transmit_pdos_.on_sync();
  receive_pdos_.on_sync();
}

void Node::on_rpdo(std::uint16_t number) noexcept {
  application_.on_rpdo(number);
}

bool Node::is_used(std::uint32_t identifier) const noexcept {
  const auto sends = transmit_pdos_.pdos();
  return routes_[identifier].service != Service::None || identifier == emcy_.identifier() ||
         std::any_of(sends.begin(), sends.end(), [=](const PdoSettings& p) { return p.identifier == identifier; });
}

void Node::on_identifiers_changed() noexcept {
  lay_routes();
  application_.on_subscriptions_changed();
}

void Node::lay_routes() noexcept {
  routes_.fill(Route{});
  const auto receives = receive_pdos_.pdos();
  for (std::size_t position = 0; position < receives.size(); ++position) {
    if (!receives[position].is_valid()) continue;
    routes_[receives[position].identifier] = {Service::Rpdo, static_cast<std::uint16_t>(position)};
  }
  routes_[function_code::kErrorControl + node_id()] = {Service::Own, 0};
  routes_[function_code::kSdoResponse + node_id()] = {Service::Own, 0};
  routes_[function_code::kSdoRequest + node_id()] = {Service::Sdo, 0};
  if (sync_.identifier() != 0) routes_[sync_.identifier()] = {Service::Sync, 0};
  routes_[function_code::kNmt] = {Service::Nmt, 0};

  subscriptions_.clear();
  for (std::uint32_t identifier = 0; identifier < routes_.size(); ++identifier) {
    if (routes_[identifier].service != Service::None) subscriptions_.push_back(identifier);
  }
}

}  // namespace canopen
