// What becomes of parameters that are replaced or saved: the objects that show them, and the services of the node.
#include <array>

#include "device/canopen_face.hpp"
#include "device/objects/abort_codes.hpp"
#include "device/parameters/object_parameters.hpp"

namespace device {
namespace {

using Cause = unit::Replacement::Cause;
using unit::ParameterGroup;
using WiredBy = UnitProcessData::WiredBy;

/// Objects with indices `first` to `last`.
struct ObjectRange {
  std::uint16_t first;
  std::uint16_t last;
};
/// The objects that show parameters of @p group, and what belongs to them.
constexpr ObjectRange objects_of(ParameterGroup group) noexcept {
  constexpr std::array kRanges{ObjectRange{0x1000, 0x9FFF}, ObjectRange{0x1000, 0x1FFF},
                               ObjectRange{0x6000, 0x9FFF}};
  return kRanges[static_cast<std::size_t>(group) - 1];
}

template <ParameterGroup Group>
bool is_shown(const drive::ParameterRow& row) noexcept {
  constexpr ObjectRange kObjects = objects_of(Group);
  return is_of_objects(row.number, kObjects.first, kObjects.last);
}

}  // namespace

/// 1010h and 1011h have groups of the parameters that objects show.
void CanopenFace::name_groups() noexcept {
  runner_.groups().define(ParameterGroup::Communication, is_shown<ParameterGroup::Communication>);
  runner_.groups().define(ParameterGroup::Application, is_shown<ParameterGroup::Application>);
}

/// What the interconnections of the standard objects are after @p replacement.
WiredBy CanopenFace::wired_by(const unit::Replacement& replacement) const noexcept {
  const bool partial = replacement.group == ParameterGroup::Communication;
  if (partial || replacement.cause == Cause::Restart) return WiredBy::Before;
  if (replacement.cause == Cause::Restored) return WiredBy::Factory;
  return runner_.has_saved_parameters() ? WiredBy::Saved : WiredBy::Factory;
}

void CanopenFace::adopt(const unit::Replacement& replacement) noexcept {
  const ObjectRange objects = objects_of(replacement.group);
  const bool is_object = replacement.object != 0;
  const Cause cause = replacement.cause;
  if (cause == Cause::Restored && !is_object) objects_.dictionary.restore(objects.first, objects.last);
  if (cause == Cause::Restored && is_object) mirrored_parameters_.bring_out(replacement.object);
  if (cause != Cause::PowerOn && cause != Cause::Restart && !is_object)
    mirrored_parameters_.bring_out(objects.first, objects.last);
  if (cause == Cause::Loaded) return;
  if (cause != Cause::PowerOn && !is_object) {
    forget_written();
    take_over_parameters();
  }
  const bool is_off =
      cause == Cause::Restart || (cause == Cause::Reset && replacement.group == ParameterGroup::All);
  if (is_off) reception_.forget();
  process_data_.take_over(wired_by(replacement));
}

/// What a reset or the start of the communication begins anew by itself is not told twice.
void CanopenFace::resume(const unit::Replacement& replacement) noexcept {
  if (replacement.cause == Cause::Restart) {
    restarting_ = true;
    node_.start(now());
    restarting_ = false;
  }
  if (replacement.cause != Cause::Restored) return;
  if (replacement.object == 0) error_objects_.show_again();
  if (replacement.group != ParameterGroup::Application) node_.reload(now());
}

/// Controlwords that wait for a cycle are void.
void CanopenFace::forget_written() noexcept {
  for (AxisObjects& axis : axes_) axis.forget_written();
}

/// What parameters of the unit say of its communication, whichever way they came.
void CanopenFace::take_over_parameters() noexcept {
  const canopen::PdoCycle grid{runner_.clock().period(), node_time(runner_.clock().last())};
  communication_.set_start_state();
  node_.set_pdo_cycle(grid);
  reception_.take_over(grid);
}

canopen::Result<void> CanopenFace::on_store(std::uint8_t sub_index) noexcept {
  const auto refused = runner_.store(ParameterGroup{sub_index});
  if (runner_.is_saving()) node_.defer_answer();
  return result(refused);
}

canopen::Result<void> CanopenFace::on_restore(std::uint8_t sub_index) noexcept {
  return result(runner_.restore(ParameterGroup{sub_index}));
}

canopen::Result<void> CanopenFace::write_object(const canopen::Entry& entry, std::int64_t value) noexcept {
  tell_time();
  auto written = objects_.dictionary.write(entry, value);
  follow_up_all();
  return written;
}

canopen::Result<void> CanopenFace::write_object(const canopen::Entry& entry,
                                                std::span<const std::uint8_t> text) noexcept {
  tell_time();
  auto written = objects_.dictionary.write_text(entry, text);
  follow_up_all();
  return written;
}

void CanopenFace::on_stored(bool kept) noexcept {
  listener_.on_saved(kept);
  communication_.lead_answers();
  node_.answer_deferred(kept ? canopen::Result<void>{} : canopen::refuse(canopen::AbortCode::HardwareError),
                        now());
  communication_.lead_frames();
}

void CanopenFace::on_reset(canopen::NmtCommand command) noexcept {
  const bool all = command == canopen::NmtCommand::ResetNode;
  if (restarts_unit_) {
    runner_.restart_unit();
  } else if (all) {
    runner_.power_off();
  } else {
    lose_connection();
  }
  runner_.show_messages();
  runner_.reload(all ? ParameterGroup::All : ParameterGroup::Communication);
}

bool CanopenFace::restart_unit() noexcept {
  restarts_unit_ = true;
  node_.command(canopen::NmtCommand::ResetNode, now());
  restarts_unit_ = false;
  return true;
}

}  // namespace device
