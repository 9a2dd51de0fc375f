#include <fmt/format.h>

#include "audit/sdo/dialogue.hpp"
#include "audit/sdo/sdo_rules.hpp"

namespace audit {

namespace sdo = canopen::sdo;
namespace rules = sdo_rules;

using sdo::CommandByte;

void Dialogue::begin_download(const Heard& heard, Findings& findings) {
  const CommandByte command{heard.frame.data[0]};
  if (!command.is_expedited()) {
    told_size_ = sdo::size_in(heard.frame);
    return;
  }
  is_last_ = true;
  const std::size_t size = command.has_size() ? command.expedited_size() : 4U;
  add_bytes(&heard.frame.data[4], size);
  transfer_.is_size_told = command.has_size();
  if (!command.has_size()) findings.add(rules::kSizeUntold, channel_.node, {heard}, [&] { return object(); });
}

/// Whether a segment may be sent or asked for now.
bool Dialogue::expects_segment(const Heard& heard, bool is_write, Findings& findings) {
  if (phase_ == Phase::Segments && transfer_.is_write == is_write) return true;
  if (aborted_)
    findings.add(rules::kAfterAbort, channel_.node, {*aborted_, heard}, [&] { return object(); });
  else if (phase_ != Phase::Idle || asked_.at == canopen::Duration{} || !given_up_)
    findings.add(rules::kSegmentAlone, channel_.node, {heard},
                 [&] { return std::string{is_write ? "a segment is sent" : "a segment is asked for"}; });
  return false;
}

void Dialogue::take_download_segment(const Heard& heard, Findings& findings) {
  if (!expects_segment(heard, true, findings)) return;
  const CommandByte command{heard.frame.data[0]};
  asked_ = heard;
  phase_ = Phase::SegmentAsked;
  if (command.toggle() != toggle_)
    return blame(rules::kToggle, heard, findings,
                 fmt::format("{} instead of {}", command.toggle() >> 4, toggle_ >> 4));
  add_bytes(&heard.frame.data[1], command.segment_size());
  is_last_ = command.is_last();
  const bool is_beyond = told_size_ && transfer_.bytes > *told_size_;
  if (told_size_ && (is_beyond || (is_last_ && transfer_.bytes != *told_size_)))
    blame(rules::kSize, heard, findings, fmt::format("{} bytes of {} told", transfer_.bytes, *told_size_));
}

void Dialogue::take_upload_segment_request(const Heard& heard, Findings& findings) {
  if (!expects_segment(heard, false, findings)) return;
  const CommandByte command{heard.frame.data[0]};
  asked_ = heard;
  phase_ = Phase::SegmentAsked;
  if (command.toggle() != toggle_)
    blame(rules::kToggle, heard, findings, fmt::format("{} instead of {}", command.toggle() >> 4, toggle_ >> 4));
}

std::optional<Transfer> Dialogue::take_segment_answer(const Heard& heard) {
  toggle_ ^= 0x10;
  if (!transfer_.is_write) {
    const CommandByte command{heard.frame.data[0]};
    add_bytes(&heard.frame.data[1], command.segment_size());
    is_last_ = command.is_last();
  }
  if (is_last_) return finished(Transfer::End::Done, heard);
  phase_ = Phase::Segments;
  return std::nullopt;
}

}  // namespace audit
