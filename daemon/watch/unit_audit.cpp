#include "daemon/watch/unit_audit.hpp"

#include "audit/auditor.hpp"
#include "eds/description/dictionary.hpp"
#include "libcanopen/base/cob_id.hpp"

namespace axisd {
namespace {

/// Frames of a turn that wait until it is over; with more it is judged before.
constexpr std::size_t kMostWaiting = 256;

/// Whether @p frame is the boot-up message of @p node_id (CiA 301, 7.2.8.3.3).
bool is_boot_up(const canopen::Frame& frame, std::uint8_t node_id) noexcept {
  return frame.id == canopen::function_code::kErrorControl + node_id && !frame.extended && !frame.remote &&
         frame.length == 1 && frame.data[0] == 0;
}

/// Whether @p frame is an NMT command to another node than @p node_id, whose answer is not heard.
bool is_to_another(const canopen::Frame& frame, std::uint8_t node_id) noexcept {
  return frame.id == canopen::function_code::kNmt && !frame.extended && !frame.remote && frame.length == 2 &&
         frame.data[1] != 0 && frame.data[1] < audit::Network::kNodes && frame.data[1] != node_id;
}

}  // namespace

UnitAudit::UnitAudit(const device::Device& device, FrameTap& tap, canopen::TimePoint started) noexcept
    : device_{device}, tap_{tap}, started_{started} {}

UnitAudit::~UnitAudit() {
  if (auditor_) tap_.remove(*this);
}

bool UnitAudit::begin() {
  if (auditor_) return true;
  if (!tap_.add(*this)) return false;
  auditor_ = std::make_unique<audit::Auditor>(audit::Circumstances{.hears_all = false});
  waiting_.reserve(kMostWaiting);
  return true;
}

void UnitAudit::on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept {
  if (is_to_another(frame, device_.node_id())) return;
  if (waiting_.size() == kMostWaiting) judge();
  waiting_.push_back({.frame = frame, .at = time - started_, .place = ++heard_});
  if (direction == Direction::Sent && is_boot_up(frame, device_.node_id())) has_booted_ = true;
}

void UnitAudit::on_handled(canopen::TimePoint) noexcept {
  if (!waiting_.empty()) judge();
  if (!has_booted_) return;
  has_booted_ = false;
  auditor_->describe(eds::describe(device_.dictionary()));
}

void UnitAudit::judge() noexcept {
  for (const audit::Heard& heard : waiting_) auditor_->take(heard);
  waiting_.clear();
}

}  // namespace axisd
