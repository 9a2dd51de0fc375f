#include "audit/drive/drive_topic.hpp"

#include "audit/base/transfer.hpp"
#include "audit/network/pdo_record.hpp"
#include "libcanopen/base/object_index.hpp"

namespace audit {

using meaning::Role;

namespace {

/// Whether @p transfer takes an RPDO out of use.
bool takes_rpdo_away(const Transfer& transfer) {
  const auto record = pdo_at(transfer.at.index);
  return record && record->is_receive && transfer.is_written(record->communication(), kCobIdSub) &&
         (transfer.value & canopen::cob_id::kInvalid) != 0;
}

}  // namespace

void DriveTopic::on_frame(const Passage& passage, const Scene& scene) {
  if (passage.heard.is_error || passage.frame().remote) return;
  const Role role = passage.meaning.role;
  if (role == Role::Sync)
    for (auto& [place, axis] : axes_) axis.take_sync(passage.heard);
  if (role == Role::Nmt)
    for (auto& [place, axis] : axes_)
      if (passage.frame().data[1] == 0 || passage.frame().data[1] == place.first) axis.leave_pdos();
  if (passage.is_boot_up())
    std::erase_if(axes_, [&](const auto& axis) { return axis.first.first == passage.meaning.node; });
  if (role != Role::Rpdo && role != Role::Tpdo) return;
  for (const DriveValue& value : values_.in_pdo(passage, scene.network)) course_of(value).take(value, scene);
}

AxisCourse& DriveTopic::course_of(const DriveValue& value) {
  return axes_.try_emplace({value.node, value.axis}, has_times_).first->second;
}

void DriveTopic::on_transfer(const Transfer& transfer, const Scene& scene) {
  for (const DriveValue& value : values_.in_transfer(transfer)) {
    AxisCourse& axis = course_of(value);
    if (transfer.is_done())
      axis.take(value, scene);
    else if (transfer.is_write && transfer.end == Transfer::End::AbortedByServer)
      axis.take_refused(value, scene.findings);
  }
  if (takes_rpdo_away(transfer))
    for (auto& [place, axis] : axes_)
      if (place.first == transfer.channel.node) axis.leave_pdos();
  const bool looks =
      transfer.at.index == canopen::object::kErrorField || transfer.at.index == canopen::object::kErrorRegister;
  if (!looks || transfer.is_write) return;
  for (auto& [place, axis] : axes_)
    if (place.first == transfer.channel.node) axis.look();
}

}  // namespace audit
