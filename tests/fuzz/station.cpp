#include "tests/fuzz/station.hpp"

#include <algorithm>

#include "tests/fakes/candump.hpp"
#include "tests/fuzz/check.hpp"

namespace fuzz {

using canopen::Frame;
using canopen::Identifier;
using canopen::NmtState;
using canopen::Result;

namespace {

constexpr std::uint8_t kNodeId = 5;
constexpr int kMostDeadlines = 48;  // that are met in one event
constexpr std::size_t kSubBlock = 127;
/// Between two runs: longer than anything that a run may have left behind.
constexpr canopen::Duration kPause = std::chrono::hours{2};

constexpr Frame kResetNode{.length = 2, .data = {0x81, 0}};
constexpr std::array<DomainMode, kDomains> kModes{
    DomainMode{.size = 20}, DomainMode{.size = 100, .unknown_size = true}, DomainMode{.size = 2000}, DomainMode{}};

void require_owned(canopen::Dictionary& dictionary, canopen::EntryOwner& owner) {
  dictionary.own_write(kJudgedNumber, 0, owner);
  dictionary.own_write(kJudgedText, 0, owner);
}

std::uint64_t bits_of(const Frame& frame) noexcept {
  return canopen::load<std::uint64_t>(frame.data.data()) ^ (std::uint64_t{frame.id} << 40) ^ frame.length;
}

bool is_pdo(const Frame& frame, const LegalFrames& legal) noexcept {
  return std::ranges::any_of(legal.pdos, [&](const LegalFrames::Pdo& pdo) {
    return pdo.identifier != 0 && pdo.identifier == canopen::identifier_of(frame) && pdo.length == frame.length;
  });
}

bool is_sdo_request(const Frame& frame) noexcept {
  return frame.length == 8 && !frame.remote;
}

}  // namespace

Station::Station(const canopen::Policy& policy)
    : dictionary_{table(), kNodeId},
      node_{dictionary_, policy, *this, *this},
      reader_{dictionary_},
      timeout_{policy.sdo_timeout},
      state_after_reset_{policy.start_state} {
  require_owned(dictionary_, *this);
  for (std::size_t i = 0; i < kDomains; ++i)
    dictionary_.own_domain(static_cast<std::uint16_t>(kFirstDomain + i), 0, domains_[i]);
  sent_.reserve(kMostFrames);
  after_ = reader_.read();
  node_.start(now_);
}

void Station::reset() {
  now_ += kPause;
  answers_ = {};
  watch_.forget();
  dictionary_.restore(0xA000, 0xFFFF);  // what no reset command restores
  act([](canopen::Node& node, canopen::TimePoint now) { node.on_frame(kResetNode, now); });
  require(!sent_.empty() && sent_.front().id == after_.error_control, "a node that boots says so first");
  require(node_.state() == state_after_reset_, "a node that has booted is in its start state");
  for (const Domain& domain : domains_)
    require(!domain.is_being_written(), "a reset cancels what is being written");
  for (std::size_t i = 0; i < kDomains; ++i) domains_[i].reset(kModes[i]);
  transcript_ = 0;  // the state that the reset has ended is another run's
}

void Station::begin() noexcept {
  sent_.clear();
  before_ = after_;
  state_before_ = node_.state();
}

void Station::finish(Parameters parameters) noexcept {
  if (node_.next_deadline() <= now_) node_.on_time(now_);
  require(node_.next_deadline() > now_, "what is due has been handled");
  require(node_.state() != NmtState::Initialising, "a node does not stay in Initialising");
  if (parameters == Parameters::MayChange || node_.state() != state_before_) after_ = reader_.read();
  if (after_.responses != before_.responses || after_.requests != before_.requests) {
    watch_.forget();
    check_subscriptions();
  }
  for (const Frame& frame : sent_) check_frame(frame);
  for (const Domain& domain : domains_)
    require(!domain.is_being_written() || node_.state() != NmtState::Stopped, "no transfer outlives Stopped");
}

/// Who filters frames by the node's list must not lose a request.
void Station::check_subscriptions() const noexcept {
  const auto wanted = node_.subscriptions();
  for (const Identifier request : after_.requests)
    require(request == 0 || std::ranges::count(wanted, canopen::Subscription{request}) == 1,
            "a server that exists is listened to");
}

void Station::receive(const Frame& frame) {
  begin();
  if (is_traced_) say("->", frame);
  const std::size_t asked = server_of(frame);
  for (Domain& domain : domains_) domain.server = asked;
  node_.on_frame(frame, now_);
  const std::size_t at_once = sent_.size();
  for (Domain& domain : domains_) domain.server = kServers;
  finish(asked != kServers || frame.id == 0 ? Parameters::MayChange : Parameters::Stay);
  if (asked != kServers) check_answers(asked, at_once, frame);
}

void Station::pass(canopen::Duration time, bool meets_deadlines) {
  const canopen::TimePoint end = now_ + time;
  for (int i = 0; meets_deadlines && i < kMostDeadlines && node_.next_deadline() < end; ++i) pass_to_deadline();
  begin();
  now_ = end;
  finish(Parameters::Stay);
}

void Station::pass_to_deadline() {
  if (node_.next_deadline() == canopen::kNever) return;
  begin();
  now_ = std::max(now_, node_.next_deadline());
  finish(Parameters::Stay);
}

void Station::set(const canopen::Entry& entry, std::int64_t value) {
  dictionary_.set(entry, value);
  act([](canopen::Node& node, canopen::TimePoint now) { node.on_values_changed(now); });
}

void Station::finish_run() {
  check_limits();
}

void Station::say(const char* who, const Frame& frame) const {
  const auto time = std::chrono::duration<double>{now_.time_since_epoch()}.count();
  std::printf("%13.6f %s %s\n", time, who, fakes::candump(frame).c_str());
  std::fflush(stdout);
}

void Station::send(const Frame& frame, canopen::Delivery) {
  if (node_.state() == NmtState::Initialising) {
    require(frame.id == after_.error_control && frame.length == 1 && frame.data[0] == 0,
            "nothing but the boot-up message is sent while initialising");
  }
  require(sent_.size() < kMostFrames, "no event causes a flood of frames");
  if (frame.id == after_.error_control && frame.data[0] == 0) watch_.forget();  // all services start afresh
  sent_.push_back(frame);
  if (is_traced_) say("<-", frame);
  note(bits_of(frame));
}

void Station::check_frame(const Frame& frame) const noexcept {
  require(frame.length <= 8 && !frame.remote, "a slave sends data frames of up to eight bytes");
  require(frame.id <= (frame.extended ? canopen::cob_id::kLong : canopen::cob_id::kBase), "an identifier fits");
  for (std::size_t i = frame.length; i < 8; ++i) require(frame.data[i] == 0, "unused bytes are 0");
  require(is_legal(frame, before_) || is_legal(frame, after_), "a frame is one that the dictionary announces");
  if (state_before_ != NmtState::Operational && node_.state() != NmtState::Operational)
    require(!is_pdo(frame, before_) && !is_pdo(frame, after_), "PDOs are for Operational alone");
  if (state_before_ != NmtState::Stopped || node_.state() != NmtState::Stopped) return;
  require(frame.id == after_.error_control && !frame.extended, "a stopped node is silent but for error control");
}

bool Station::is_legal(const Frame& frame, const LegalFrames& legal) const noexcept {
  const Identifier identifier = canopen::identifier_of(frame);
  if (identifier == legal.error_control) return frame.length == 1;
  if (identifier == legal.emcy) return frame.length == 8;
  if (std::ranges::count(legal.responses, identifier) != 0) return frame.length == 8;
  return is_pdo(frame, legal);
}

std::size_t Station::server_of(const Frame& frame) const noexcept {
  const Identifier identifier = canopen::identifier_of(frame);
  for (std::size_t server = 0; server < kServers; ++server)
    if (identifier == before_.requests[server] && identifier != 0 && is_sdo_request(frame)) return server;
  return kServers;
}

/// The server @p asked answers with one frame, or with a sub-block at most; no other server says anything.
void Station::check_answers(std::size_t asked, std::size_t at_once, const Frame& request) noexcept {
  std::size_t answers = 0;
  for (const Frame& frame : std::span{sent_}.first(at_once)) {
    const auto server = std::ranges::find(before_.responses, canopen::identifier_of(frame));
    if (server == before_.responses.end()) continue;
    require(server == before_.responses.begin() + static_cast<std::ptrdiff_t>(asked), "only who is asked answers");
    ++answers;
  }
  const bool is_block_upload = (request.data[0] & 0xE0) == 0xA0;
  require(answers <= (is_block_upload ? kSubBlock + 1 : 1), "a request has one answer, or a sub-block");
  const bool is_first = !sent_.empty() && canopen::identifier_of(sent_.front()) == before_.responses[asked];
  const std::size_t told = is_first && answers == 1 ? 1 : 0;
  if (state_before_ != NmtState::Stopped) {
    watch_.note(asked, request, std::span{sent_}.first(told), now_, timeout_);
  }
}

void Station::check_limits() const noexcept {
  for (const canopen::Entry& entry : dictionary_.entries()) {
    if (entry.size == 0) continue;
    const std::int64_t value = dictionary_.stored(entry);
    if (entry.description->type == canopen::DataType::Boolean && !entry.receive_mappable)
      require(value == 0 || value == 1, "a BOOLEAN is 0 or 1");
    if (!entry.limited || entry.order != canopen::ValueOrder::Integer || entry.receive_mappable) continue;
    require(value >= entry.low && value <= entry.high, "a value stays within its limits");
  }
}

void Station::on_nmt_state(NmtState from, NmtState to) noexcept {
  note(0x100 + static_cast<unsigned>(from) * 256 + static_cast<unsigned>(to));
  watch_.forget();
}

void Station::on_communication_error(canopen::CommunicationError error, std::uint16_t detail) noexcept {
  note(0x10000 + static_cast<unsigned>(error) * 256 + detail);
}

void Station::on_communication_recovery(canopen::CommunicationError error, std::uint16_t detail) noexcept {
  note(0x20000 + static_cast<unsigned>(error) * 256 + detail);
}

void Station::on_heartbeat(std::uint8_t node_id, NmtState state) noexcept {
  note(0x30000U + node_id * 256U + static_cast<unsigned>(state));
}

Result<void> Station::on_store(std::uint8_t sub_index) noexcept {
  note(0x40000U + sub_index);
  return answers_.store ? Result<void>{} : canopen::refuse(canopen::AbortCode::HardwareError);
}

Result<void> Station::on_restore(std::uint8_t sub_index) noexcept {
  note(0x50000U + sub_index);
  return answers_.restore ? Result<void>{} : canopen::refuse(canopen::AbortCode::HardwareError);
}

Result<void> Station::write(const canopen::Entry&, std::int64_t value) {
  note(0x60000U ^ static_cast<std::uint64_t>(value));
  return answers_.judged_number ? Result<void>{} : canopen::refuse(canopen::AbortCode::LocalControl);
}

Result<void> Station::write_text(const canopen::Entry&, std::span<const std::uint8_t> text) {
  note(0x70000U + text.size());
  return answers_.judged_text ? Result<void>{} : canopen::refuse(canopen::AbortCode::InvalidValue);
}

}  // namespace fuzz
