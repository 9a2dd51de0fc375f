#include "can/hub/trunk/arbitration.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "can/hub/trunk/lateness.hpp"

namespace hub::trunk {

using canopen::TimePoint;

namespace {

/// Requests that are taken before members have their turn.
constexpr int kRequestsATurn = 64;

}  // namespace

Arbitration::Arbitration(Stream& stream, std::unique_ptr<Lease> lease, Notices& notices, std::uint32_t hub,
                         std::uint32_t bit_rate)
    : stream_{stream},
      lease_{std::move(lease)},
      notices_{notices},
      candidate_{*lease_, hub, kMostLateness},
      arbiter_{bit_rate} {}

void Arbitration::begin(TimePoint now) noexcept {
  terms_.forget();
  candidate_.begin(now);
}

void Arbitration::step_down(bool is_open) noexcept {
  if (std::exchange(own_term_, 0) == 0) return;
  arbiter_.begin(0);
  has_more_ = false;
  if (is_open) stream_.listen(false);
}

Arbitration::Verdict Arbitration::judge(const Header& header, bool is_stale, TimePoint now) noexcept {
  const Verdict verdict = terms_.judge(header, is_stale);
  if (verdict == Verdict::Obey || verdict == Verdict::Begin) candidate_.on_arbiter(now);
  if (verdict == Verdict::End) candidate_.on_end(now);
  if (terms_.term() > own_term_ || (verdict == Verdict::End && terms_.term() == own_term_)) step_down(true);
  return verdict;
}

void Arbitration::on_beat(const Header& header) noexcept {
  if (is_arbiter()) arbiter_.on_epoch(header.hub, header.epoch);
}

void Arbitration::turn(std::int64_t seen, TimePoint now) noexcept {
  if (!is_arbiter()) return;
  Stream::Message message;
  has_more_ = true;
  for (int i = 0; i < kRequestsATurn && has_more_; ++i) {
    has_more_ = stream_.receive_request(message);
    if (has_more_) take_request(message.bytes, seen, now);
  }
  if (has_more_) return;  // what has come in takes part in the arbitration
  arbiter_.look(seen);
  is_unsent_ = false;
  while (const auto granted = arbiter_.pass(now)) publish(granted->header, seen, &*granted);
  while (const auto lost = arbiter_.take_lost()) publish(*lost, seen, nullptr);
  if (is_unsent_) stream_.flush();
}

void Arbitration::take_request(std::span<const std::byte> bytes, std::int64_t seen, TimePoint now) noexcept {
  std::string_view problem;
  const auto request = Reader::read(bytes, problem);
  if (request && !is_of_arbiter(request->header().kind)) return arbiter_.take(*request, seen, now);
  ++malformed_;
  notices_.tell(fmt::format("request {}", request ? "is none of a hub" : problem), now);
}

void Arbitration::publish(Header header, std::int64_t seen, const Arbiter::Granted* granted) noexcept {
  header.seen = seen;
  header.term = own_term_;
  Writer writer;
  writer.begin(header);
  if (granted != nullptr) writer.add_granted(granted->frame, granted->end);
  stream_.publish(writer.finish());
  is_unsent_ = true;
}

bool Arbitration::seek(TimePoint now) noexcept {
  if (is_arbiter()) return false;
  const auto gained = candidate_.seek(terms_.term(), now);
  if (const std::string problem = lease_->take_problem(); !problem.empty()) notices_.tell(problem, now);
  if (!gained) return false;
  own_term_ = *gained;
  arbiter_.begin(own_term_);
  stream_.listen(true);
  return true;
}

TimePoint Arbitration::next_deadline(bool may_seek) const noexcept {
  if (is_arbiter()) return has_more_ ? TimePoint::min() : arbiter_.next_deadline();
  return may_seek ? candidate_.next_deadline(terms_.term()) : canopen::kNever;
}

}  // namespace hub::trunk
