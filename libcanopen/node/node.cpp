#include "libcanopen/node/node.hpp"

#include <algorithm>
#include <cassert>

#include "libcanopen/node/error_reaction.hpp"
#include "libcanopen/node/standard_services.hpp"
#include "libcanopen/node/state_machine.hpp"
#include "libcanopen/service/service_list.hpp"

namespace canopen {

struct Node::Parts {
  Parts(Dictionary& dictionary, const Policy& given, FrameSink& sink, Application& application)
      : context{.sink = &sink,
                .dictionary = dictionary,
                .application = application,
                .policy = policy,
                .timers = timers,
                .services = list,
                .identifiers = list,
                .errors = errors,
                .nmt = states},
        list{context},
        policy{given},
        states{context, policy, list},
        services{context},
        errors{context, services} {}

  TimerQueue timers;
  Context context;
  ServiceList list;
  Policy policy;
  StateMachine states;
  StandardServices services;
  ErrorReaction errors;
};

Node::Node(Dictionary& dictionary, const Policy& policy, FrameSink& sink, Application& application)
    : parts_{std::make_unique<Parts>(dictionary, policy, sink, application)},
      now_{&parts_->context.now},
      earliest_{&parts_->timers.earliest()} {}

Node::~Node() = default;

void Node::show(SdoView& view) noexcept {
  parts_->context.view = &view;
}

Context& Node::context() noexcept {
  return parts_->context;
}

void Node::send_to(FrameSink& sink) noexcept {
  parts_->context.sink = &sink;
}

void Node::set_pdo_cycle(const PdoCycle& cycle) noexcept {
  parts_->services.transmit.set_cycle(cycle);
}

void Node::start(TimePoint now) noexcept {
  *now_ = now;
  parts_->states.start();
}

void Node::set_start_state(NmtState state) noexcept {
  assert(state != NmtState::Initialising);
  parts_->policy.start_state = state;
}

void Node::set_node_id(std::uint8_t node_id) noexcept {
  assert(is_node_id(node_id) || node_id == kNoNodeId);
  parts_->context.pending_node_id = node_id;
}

void Node::reload(TimePoint now) noexcept {
  *now_ = now;
  parts_->states.reload();
}

void Node::on_frame(const Frame& frame, TimePoint now) noexcept {
  Parts& parts = *parts_;
  parts.context.now = now;
  parts.list.on_frame(frame);
}

void Node::command(NmtCommand wanted, TimePoint now) noexcept {
  *now_ = now;
  if (state() != NmtState::Initialising) parts_->services.nmt.command(wanted);
}

void Node::on_timers() noexcept {
  while (const auto timer = parts_->timers.take_due(*now_)) parts_->list.on_timer(*timer);
}

void Node::on_values_changed(TimePoint now) noexcept {
  Parts& parts = *parts_;
  parts.context.now = now;
  parts.services.transmit.on_values_changed();
}

void Node::send_emcy(std::uint16_t code, std::uint8_t error_register,
                     const std::array<std::uint8_t, 5>& manufacturer) noexcept {
  parts_->services.emcy.send(code, error_register, manufacturer);
}

void Node::raise_error(std::uint16_t code, std::uint16_t detail, std::uint8_t error_register) noexcept {
  parts_->errors.raise(code, detail, error_register);
}

void Node::clear_error(std::uint16_t code, std::uint16_t detail) noexcept {
  parts_->errors.clear(code, detail);
}

void Node::report(CommunicationError error, TimePoint now) noexcept {
  *now_ = now;
  parts_->errors.on_error(error, 0);
}

void Node::report_recovery(CommunicationError error, TimePoint now) noexcept {
  *now_ = now;
  parts_->errors.on_recovery(error, 0);
}

void Node::defer_answer() noexcept {
  parts_->context.answer_deferred = true;
}

void Node::answer_deferred(const Result<void>& result, TimePoint now) noexcept {
  *now_ = now;
  parts_->services.sdo.answer_deferred(result);
}

void Node::apply_error_behaviour(std::uint8_t error_class) noexcept {
  parts_->errors.apply_behaviour(error_class);
}

NmtState Node::state() const noexcept {
  return parts_->context.state;
}

std::uint8_t Node::node_id() const noexcept {
  return parts_->context.dictionary.node_id();
}

std::span<const Subscription> Node::subscriptions() const noexcept {
  return parts_->list.subscriptions();
}

bool Node::uses(Identifier identifier) const noexcept {
  return parts_->list.is_used(identifier);
}

std::span<const PdoSettings> Node::receive_pdos() const noexcept {
  return parts_->services.receive.pdos();
}

std::span<const PdoSettings> Node::transmit_pdos() const noexcept {
  return parts_->services.transmit.pdos();
}

std::size_t Node::valid_pdos(Direction direction) const noexcept {
  const auto pdos = direction == Direction::Receive ? receive_pdos() : transmit_pdos();
  return static_cast<std::size_t>(std::ranges::count_if(pdos, &PdoSettings::is_valid));
}

std::size_t Node::sdo_servers() const noexcept {
  return parts_->services.sdo.count();
}

const SdoAnswerCounters& Node::sdo_answers(std::size_t position) const noexcept {
  return parts_->services.sdo.answers(position);
}

std::uint64_t Node::short_rpdos() const noexcept {
  return parts_->services.receive.too_short();
}

std::uint64_t Node::late_rpdos() const noexcept {
  return parts_->services.receive.too_late();
}

}  // namespace canopen
