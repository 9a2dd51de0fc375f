#include "libcanopen/node/node.hpp"

#include <algorithm>
#include <cassert>

namespace canopen {
namespace {

constexpr std::uint16_t kFirstCommunicationObject = 0x1000;
constexpr std::uint16_t kLastCommunicationObject = 0x1FFF;
constexpr std::uint16_t kFirstApplicationObject = 0x2000;
constexpr std::uint16_t kLastApplicationObject = 0x9FFF;

/// Routes besides those of PDOs, SDO servers and monitored nodes: NMT, SYNC, TIME, and three of its own.
constexpr std::size_t kSingleRoutes = 6;

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

Node::TimerPlan::TimerPlan(const Dictionary& dictionary) noexcept
    : consumer{sdo + SdoServers::timers_for(dictionary)},
      rpdo{consumer + HeartbeatConsumer::timers_for(dictionary)},
      tpdo{rpdo + ReceivePdos::timers_for(dictionary)},
      count{tpdo + TransmitPdos::timers_for(dictionary)} {}

Node::Node(Dictionary& dictionary, const Policy& policy, FrameSink& sink, Application& application)
    : policy_{policy},
      plan_{dictionary},
      timers_{plan_.count},
      context_{.sink = &sink,
               .dictionary = dictionary,
               .application = application,
               .policy = policy_,
               .timers = timers_,
               .identifiers = *this,
               .errors = *this},
      guarding_{context_, plan_.guarding},
      heartbeat_{context_, plan_.heartbeat},
      heartbeat_consumer_{context_, plan_.consumer},
      error_behaviour_{dictionary},
      sdo_servers_{context_, plan_.sdo},
      receive_pdos_{context_, plan_.rpdo},
      transmit_pdos_{context_, plan_.tpdo},
      sync_{context_},
      time_{context_},
      emcy_{context_, plan_.emcy},
      errors_{context_, emcy_},
      storage_{context_},
      routes_{receive_pdos_.pdos().size() + transmit_pdos_.pdos().size() + sdo_servers_.servers().size() +
              heartbeat_consumer_.identifiers().size() + kSingleRoutes} {}

void Node::start(TimePoint now) noexcept {
  context_.now = now;
  const bool runs_on = context_.state == NmtState::Operational && policy_.start_state == NmtState::Operational;
  if (runs_on) enter(NmtState::PreOperational);  // or nothing would begin anew
  boot();
}

void Node::on_frame(const Frame& frame, TimePoint now) noexcept {
  if (context_.state == NmtState::Initialising) return;  // a write to the dictionary may have laid routes already
  context_.now = now;
  if (frame.remote) return on_remote(frame);
  const Route route = routes_.of(frame);
  switch (route.service) {
    case Service::Sdo:
      if (gate_.sdo) sdo_servers_.on_frame(route.position, frame);
      break;
    case Service::ViewedSdo:
      if (gate_.sdo) sdo_servers_.on_viewed_frame(route.position, frame);
      break;
    case Service::Rpdo:
      if (gate_.pdo) receive_pdos_.on_frame(route.position, frame);
      break;
    case Service::Sync:
      if (gate_.sync) on_sync(frame);
      break;
    case Service::Nmt:
      on_nmt(frame);
      break;
    case Service::Heartbeat:
      heartbeat_consumer_.on_frame(route.position, frame);
      break;
    case Service::Time:
      if (gate_.time) time_.on_frame(frame);
      break;
    case Service::Own:
      context_.application.on_foreign_frame(frame.id);
      break;
    case Service::Guarding:
    case Service::TpdoRequest:
    case Service::None:
      break;
  }
}

void Node::on_remote(const Frame& frame) noexcept {
  const Route route = routes_.of_remote(frame);
  if (route.service == Service::Guarding) {
    guarding_.on_request();
  } else if (route.service == Service::TpdoRequest && gate_.pdo) {
    transmit_pdos_.on_request(route.position);
  }
}

void Node::on_timers() noexcept {
  if (context_.state == NmtState::Initialising) return timers_.clear();  // start() sets what is needed
  while (const auto timer = timers_.take_due(context_.now)) on_timer(*timer);
}

void Node::on_timer(std::size_t timer) noexcept {
  if (timer >= plan_.tpdo) return transmit_pdos_.on_timer(timer - plan_.tpdo);
  if (timer >= plan_.rpdo) return receive_pdos_.on_timer(timer - plan_.rpdo);
  if (timer >= plan_.consumer) return heartbeat_consumer_.on_timer(timer - plan_.consumer);
  if (timer >= plan_.sdo) return sdo_servers_.on_timer(timer - plan_.sdo);
  if (timer == plan_.emcy) return emcy_.on_timer();
  if (timer == plan_.guarding) return guarding_.on_timer();
  heartbeat_.on_timer();
}

void Node::on_values_changed(TimePoint now) noexcept {
  context_.now = now;
  transmit_pdos_.on_values_changed();
}

void Node::command(NmtCommand wanted, TimePoint now) noexcept {
  context_.now = now;
  if (context_.state != NmtState::Initialising) command(wanted);
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
  context_.application.on_reset(command);
  boot();
}

void Node::boot() noexcept {
  emcy_.reload();
  errors_.reload();  // before the services whose errors end: no EMCY tells of it
  sdo_servers_.forget();
  sdo_servers_.reload();
  receive_pdos_.reload();
  transmit_pdos_.reload();
  sync_.reload();
  time_.reload();
  heartbeat_consumer_.reload();
  claim_identifiers();
  context_.sink->send(frame_under(function_code::kErrorControl + node_id(), 1), Delivery::Ordered);
  heartbeat_.reload();
  guarding_.reload();
  enter(policy_.start_state);
}

/// The identifiers of all services but PDOs are there.
void Node::claim_identifiers() noexcept {
  lay_routes();  // those that PDOs must leave alone
  receive_pdos_.claim_identifiers();
  transmit_pdos_.claim_identifiers();
  on_identifiers_changed();
}

void Node::set_start_state(NmtState state) noexcept {
  assert(state != NmtState::Initialising);
  policy_.start_state = state;
}

void Node::reload(TimePoint now) noexcept {
  context_.now = now;
  if (context_.state == NmtState::Initialising) return;
  transmit_pdos_.take_over();  // first: nothing is sent while the settings are not in force
  emcy_.take_over();
  errors_.take_over();
  sdo_servers_.reload();
  receive_pdos_.reload();
  sync_.reload();
  time_.reload();
  heartbeat_consumer_.take_over();
  claim_identifiers();
  heartbeat_.take_over();
  guarding_.take_over();
  if (context_.state == NmtState::Operational) transmit_pdos_.start();
}

std::size_t Node::valid_pdos(Direction direction) const noexcept {
  const auto pdos = direction == Direction::Receive ? receive_pdos() : transmit_pdos();
  return static_cast<std::size_t>(std::ranges::count_if(pdos, &PdoSettings::is_valid));
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
  if (!gate_.sdo) sdo_servers_.forget();
  if (!gate_.emcy) emcy_.forget();
  context_.application.on_nmt_state(from, state);
  const bool stays = context_.state == state;  // the application may have left it already
  if (stays && state == NmtState::Operational) transmit_pdos_.start();
}

void Node::on_sync(const Frame& frame) noexcept {
  const auto counter = sync_.on_frame(frame);
  if (!counter) return;
  if (gate_.pdo) {
    transmit_pdos_.on_sync(*counter);
    receive_pdos_.on_sync(sync_.window());
  }
  context_.application.on_sync(*counter);
}

void Node::raise_error(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept {
  if (errors_.raise(code, detail, error_register)) transmit_pdos_.on_values_changed();
}

void Node::clear_error(std::uint16_t code, std::uint16_t detail) noexcept {
  if (errors_.clear(code, detail)) transmit_pdos_.on_values_changed();
}

void Node::answer_deferred(const Result<void>& result, TimePoint now) noexcept {
  context_.now = now;
  sdo_servers_.answer_deferred(result);
}

void Node::report(CommunicationError error, TimePoint now) noexcept {
  context_.now = now;
  on_error(error, 0);
}

void Node::report_recovery(CommunicationError error, TimePoint now) noexcept {
  context_.now = now;
  on_recovery(error, 0);
}

void Node::on_error(CommunicationError error, std::uint16_t detail) noexcept {
  const CommunicationErrorRow& row = row_of(error);
  raise_error(row.emcy_code, detail, row.error_register);
  context_.application.on_communication_error(error, detail);
  if (row.changes_nmt_state) apply_error_behaviour(kCommunicationErrorClass);
}

void Node::on_recovery(CommunicationError error, std::uint16_t detail) noexcept {
  clear_error(row_of(error).emcy_code, detail);
  context_.application.on_communication_recovery(error, detail);
}

void Node::apply_error_behaviour(std::uint8_t error_class) noexcept {
  if (context_.state == NmtState::Initialising) return;
  enter(error_behaviour_.after(error_class, context_.state));
}

}  // namespace canopen
