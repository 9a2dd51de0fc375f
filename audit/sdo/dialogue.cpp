#include "audit/sdo/dialogue.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "audit/nmt/nmt_rules.hpp"
#include "audit/sdo/requests.hpp"
#include "audit/sdo/sdo_rules.hpp"
#include "libcanopen/od/abort_text.hpp"
#include "meaning/words.hpp"

namespace audit {

namespace sdo = canopen::sdo;
namespace rules = sdo_rules;

using sdo::CommandByte;
using sdo::Request;

namespace {

/// Who asks again so soon has not waited at all.
constexpr canopen::Duration kImpatience = std::chrono::milliseconds{20};
/// Time after which a master may give up.
constexpr canopen::Duration kLongWait = std::chrono::milliseconds{50};
/// A transfer that goes on so late was forgotten.
constexpr canopen::Duration kForgotten = std::chrono::seconds{1};

}  // namespace

std::optional<Transfer> Dialogue::take_request(const Heard& heard, Findings& findings) {
  const canopen::Frame& frame = heard.frame;
  if (frame.length != kSdoBytes || frame.remote) {
    findings.add(rules::kLength, channel_.node, {heard}, [&] {
      return frame.remote ? std::string{"a remote frame"} : fmt::format("{} bytes", frame.length);
    });
    return std::nullopt;
  }
  const std::uint8_t byte = frame.data[0];
  if (phase_ == Phase::Unknown && !begins_transfer(byte)) return std::nullopt;
  const bool is_anew = has_rebooted_ && BlockData::number_in(byte) != block_.number() + 1;
  if (phase_ == Phase::BlockSent && is_anew) forget();
  if (phase_ == Phase::BlockSent && byte != kAbortByte) {
    take_block_segment(heard, findings);
    return std::nullopt;
  }
  if (is_behind_abort(heard)) return std::nullopt;
  if (!is_request(byte)) {
    findings.add(rules::kCommand, channel_.node, {heard},
                 [&] { return fmt::format("command byte {:02X}h", byte); });
    return std::nullopt;
  }
  if (CommandByte{byte}.request() == Request::Abort) return take_abort(heard, findings);
  if (phase_ == Phase::BlockConfirm || phase_ == Phase::BlockReady || phase_ == Phase::BlockHeard)
    if (!begins_transfer(byte)) return take_block_upload(heard, findings);
  if (awaits_server()) note_unanswered(heard, findings);
  if (begins_transfer(byte)) {
    begin(heard, findings);
  } else if (CommandByte{byte}.request() == Request::DownloadSegment) {
    take_download_segment(heard, findings);
  } else if (CommandByte{byte}.request() == Request::UploadSegment) {
    take_upload_segment_request(heard, findings);
  } else if (aborted_) {
    findings.add(rules::kAfterAbort, channel_.node, {*aborted_, heard}, [&] { return object(); });
  }
  return std::nullopt;
}

/// Whether @p heard is a segment of a block download that was on its way when the server aborted it.
bool Dialogue::is_behind_abort(const Heard& heard) {
  const bool is_download = kind_ == Kind::Block && transfer_.is_write;
  if (phase_ != Phase::Idle || !aborted_ || !is_download || heard.at - aborted_->at >= kImpatience) return false;
  return block_.take(BlockData::number_in(heard.frame.data[0]), &heard.frame.data[1]);
}

/// The client sends something else while the server has not answered.
void Dialogue::note_unanswered(const Heard& heard, Findings& findings) {
  if (has_rebooted_) {
    phase_ = Phase::Idle;
    return;
  }
  const canopen::Duration waited = heard.at - asked_.at;
  const bool has_waited = !has_times_ || waited >= kImpatience;
  findings.add(has_waited ? rules::kUnaborted : rules::kOverlap, channel_.node, {asked_, heard}, [&] {
    const std::string told = object() + " was not answered yet";
    return waited.count() == 0 ? told : fmt::format("{}, after {:.1f} ms", told, milliseconds(waited));
  });
  if (has_waited && phase_ == Phase::Initiated) given_up_ = asked_;
  phase_ = Phase::Idle;
}

void Dialogue::begin(const Heard& heard, Findings& findings) {
  if (is_open() && !has_rebooted_) report_left_open(heard, findings);
  const CommandByte command{heard.frame.data[0]};
  const bool is_write =
      command.request() == Request::InitiateDownload || command.request() == Request::BlockDownload;
  transfer_ = {.channel = channel_, .at = sdo::address_in(heard.frame), .is_write = is_write, .request = heard};
  told_size_.reset();
  aborted_.reset();
  toggle_ = 0;
  is_last_ = false;
  asked_ = heard;
  has_gap_ = false;
  has_rebooted_ = false;
  phase_ = Phase::Initiated;
  const bool is_block = command.request() == Request::BlockUpload || command.request() == Request::BlockDownload;
  kind_ = is_block ? Kind::Block : Kind::Normal;
  if (is_block)
    begin_block(heard, is_write, findings);
  else if (is_write)
    begin_download(heard, findings);
}

/// Whether an abort was under way when the answer came, after a long wait for it.
bool Dialogue::has_crossed(const Heard& abort) const noexcept {
  return transfer_.last.at - asked_.at >= kLongWait && abort.at - transfer_.last.at < kImpatience;
}

/// Whether an abort refuses the last answer of an upload, whose end the client has not seen so.
bool Dialogue::refuses_answer(const Heard& abort) const noexcept {
  return !transfer_.is_write && transfer_.is_done() && abort.at - transfer_.last.at < kImpatience;
}

std::optional<Transfer> Dialogue::take_abort(const Heard& heard, Findings& findings) {
  const std::uint32_t code = abort_code_in(heard.frame);
  if (canopen::text_of(canopen::AbortCode{code}).empty())
    findings.add(rules::kAbortCode, channel_.node, {heard}, [&] { return fmt::format("{:08X}h", code); });
  if (phase_ == Phase::Idle) {
    const bool was_reset = transfer_.last.place == 0;
    if (!was_reset && !has_crossed(heard) && !refuses_answer(heard))
      findings.add(rules::kAbortAlone, channel_.node, {transfer_.last, heard},
                   [&] { return meaning::abort_text(code); });
    return std::nullopt;
  }
  if (awaits_server()) given_up_ = asked_;
  return finished(Transfer::End::AbortedByClient, heard, code);
}

void Dialogue::reset(const Heard& heard, Findings& findings) {
  const bool is_for_all = heard.frame.data[1] == 0;
  const bool is_there = has_answered_ || !is_for_all;  // who looks for nodes waits for nobody
  if (awaits_server() && is_there)
    findings.add(nmt_rules::kResetInTransfer, channel_.node, {asked_, heard}, [&] { return object(); });
  forget();
}

void Dialogue::take_boot_up() {
  if (phase_ == Phase::Initiated || is_open())  // the client cannot know
    has_rebooted_ = true;
  else
    forget();
}

void Dialogue::forget() {
  phase_ = Phase::Idle;
  transfer_ = {};
  given_up_.reset();
  aborted_.reset();
  refusals_ = 0;
}

void Dialogue::end(canopen::Duration at, Findings& findings) {
  const bool is_forgotten = is_open() && !awaits_server() && !has_rebooted_ && at - asked_.at >= kForgotten;
  if (is_forgotten) report_left_open(asked_, findings);
}

void Dialogue::report_left_open(const Heard& last, Findings& findings) const {
  findings.add(rules::kLeftOpen, channel_.node, {transfer_.request, last}, [&] {
    return fmt::format("{} of {}", transfer_.is_write ? "the download" : "the upload", object());
  });
}

Transfer Dialogue::finished(Transfer::End end, const Heard& last, std::uint32_t code) {
  transfer_.end = end;
  transfer_.abort_code = code;
  transfer_.last = last;
  phase_ = Phase::Idle;
  if (end == Transfer::End::Done) refusals_ = 0;
  return transfer_;
}

void Dialogue::add_bytes(const std::uint8_t* data, std::size_t size) noexcept {
  for (std::size_t i = 0; i < size && transfer_.bytes + i < sizeof transfer_.value; ++i)
    transfer_.value |= std::uint64_t{data[i]} << 8 * (transfer_.bytes + i);
  transfer_.bytes += size;
}

/// The last @p size bytes do not count.
void Dialogue::drop_bytes(std::uint64_t size) noexcept {
  transfer_.bytes -= std::min(transfer_.bytes, size);
  if (transfer_.bytes < sizeof transfer_.value) transfer_.value &= (std::uint64_t{1} << 8 * transfer_.bytes) - 1;
}

std::string Dialogue::object() const {
  return fmt::format("{:04X}h:{:02X}", transfer_.at.index, transfer_.at.sub_index);
}

/// The client has broken @p rule within its transfer.
void Dialogue::blame(const Rule& rule, const Heard& heard, Findings& findings, const std::string& text) {
  transfer_.is_malformed = true;
  findings.add(rule, channel_.node, {transfer_.request, heard},
               [&] { return fmt::format("{}: {}", object(), text); });
}

}  // namespace audit
