// Dialogue: what the server answers.
#include <fmt/format.h>

#include "audit/bus/bus_rules.hpp"
#include "audit/sdo/dialogue.hpp"
#include "audit/sdo/requests.hpp"
#include "audit/sdo/sdo_rules.hpp"
#include "meaning/words.hpp"

namespace audit {

namespace sdo = canopen::sdo;
namespace rules = sdo_rules;

using sdo::Response;

namespace {

constexpr std::uint32_t kMostRefusals = 3;  // of the same request, which the master may not have looked at yet
/// Two answers that come so close are those of one request.
constexpr canopen::Duration kTwice = std::chrono::milliseconds{100};

bool is_same(const sdo::Address& a, const sdo::Address& b) noexcept {
  return a.index == b.index && a.sub_index == b.sub_index;
}

}  // namespace

std::optional<Transfer> Dialogue::take_response(const Heard& heard, Findings& findings) {
  const canopen::Frame& frame = heard.frame;
  has_answered_ = true;
  if (frame.length != kSdoBytes || frame.remote || phase_ == Phase::Unknown) return std::nullopt;
  if (phase_ == Phase::BlockHeard && frame.data[0] != kAbortByte) {
    take_block_upload_segment(heard);
    return std::nullopt;
  }
  const sdo::Address at = sdo::address_in(frame);
  const bool is_expected = phase_ != Phase::Idle && (phase_ != Phase::Initiated || is_same(at, transfer_.at));
  if (!is_expected) {
    note_late(heard, findings);
    return std::nullopt;
  }
  if (response_of(frame) == Response::Abort) {
    aborted_ = heard;
    note_repetition(heard, findings);
    return finished(Transfer::End::AbortedByServer, heard, abort_code_in(frame));
  }
  if (phase_ == Phase::Initiated) return take_initiated(heard);
  if (phase_ == Phase::SegmentAsked) return take_segment_answer(heard);
  if (phase_ == Phase::BlockEnding || phase_ == Phase::BlockSent) return take_block_answer(heard);
  return std::nullopt;
}

std::optional<Transfer> Dialogue::take_initiated(const Heard& heard) {
  const canopen::Frame& frame = heard.frame;
  switch (response_of(frame)) {
    case Response::InitiateUpload:
      if (transfer_.is_write) return std::nullopt;
      kind_ = Kind::Normal;
      if (const unsigned bytes = meaning::expedited_bytes(frame); bytes != 0) {
        add_bytes(&frame.data[4], bytes);
        return finished(Transfer::End::Done, heard);
      }
      phase_ = Phase::Segments;
      return std::nullopt;
    case Response::InitiateDownload:
      if (!transfer_.is_write) return std::nullopt;
      if (is_last_) return finished(Transfer::End::Done, heard);
      phase_ = Phase::Segments;
      return std::nullopt;
    case Response::BlockDownload:
      start_block_download(frame);
      return std::nullopt;
    case Response::BlockUpload:
      phase_ = Phase::BlockReady;
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

/// An answer that nobody waits for any more, or a second one.
void Dialogue::note_late(const Heard& heard, Findings& findings) {
  const bool is_second = phase_ == Phase::Idle && !given_up_ && transfer_.end != Transfer::End::AbortedByClient &&
                         heard.at - transfer_.last.at < kTwice &&
                         is_same(sdo::address_in(heard.frame), transfer_.at);
  if (is_second && response_of(heard.frame) != Response::Abort)
    findings.add(bus_rules::kAnsweredTwice, channel_.node, {transfer_.request, transfer_.last, heard},
                 [&] { return object(); });
  if (!given_up_) return;
  const bool is_its_answer = is_same(sdo::address_in(heard.frame), sdo::address_in(given_up_->frame)) ||
                             !begins_transfer(given_up_->frame.data[0]);
  if (!is_its_answer) return;
  findings.add(rules::kTimeOutShort, channel_.node, {*given_up_, heard},
               [&] { return fmt::format("it comes after {:.1f} ms", milliseconds(heard.at - given_up_->at)); });
  given_up_.reset();
}

/// The server has refused what it was asked for.
void Dialogue::note_repetition(const Heard& heard, Findings& findings) {
  if (transfer_.request.frame != refused_.frame) {
    refused_ = transfer_.request;
    refusals_ = 0;
  }
  if (++refusals_ == kMostRefusals)
    findings.add(rules::kRepeated, channel_.node, {refused_, transfer_.request, heard}, [&] {
      return fmt::format("{}: {} times {}", object(), refusals_, meaning::abort_text(abort_code_in(heard.frame)));
    });
}

}  // namespace audit
