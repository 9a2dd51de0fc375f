#include "injection/wire/drive_faults.hpp"

#include <algorithm>

#include "device/objects/object_index.hpp"
#include "device/process_data/process_objects.hpp"
#include "injection/wire/kinds.hpp"

namespace injection {
namespace {

namespace object = device::object;

/// r8750: the objects that the received words carry.
constexpr std::uint16_t kReceivedObjects = 8750;
/// Of the first axis (CiA 301).
constexpr std::uint16_t kFirstProfileObject = 0x6000;

bool is(const Loaded& loaded, std::string_view kind) noexcept {
  return loaded.was_hit && loaded.fault.kind->name == kind;
}

bool is_of(const Loaded& loaded, std::size_t axis) noexcept {
  return loaded.fault.allows(Argument::Axis, static_cast<std::uint32_t>(axis + 1));
}

}  // namespace

DriveFaults::DriveFaults(device::Device& device, const std::vector<Loaded>& loaded, CycleListener& listener)
    : device_{device},
      loaded_{loaded},
      listener_{listener},
      inner_{device.canopen_face()},
      dictionary_{device.objects()},
      axes_(device.unit().axes().size()) {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto add = [&](std::uint16_t index) {
      if (const canopen::Entry* const entry = dictionary_.lookup(index, 0)) axes_[i].shown.push_back(entry);
    };
    if (device_.spoil(i + 1, {}))
      add_actual_values(i);
    else
      for (const device::SentObject& sent : device::kSentObjects)
        if (sent.index != object::kStatusword) add(object::on_axis(sent.index, i + 1));
    for (std::uint16_t n = 0; n < object::kFreeWords; ++n)
      add(static_cast<std::uint16_t>(object::free_on_axis(object::kTransmitWords, i + 1) + n));
    for (std::uint16_t n = 0; n < object::kFreeDoubleWords; ++n)
      add(static_cast<std::uint16_t>(object::free_on_axis(object::kTransmitDoubleWords, i + 1) + n));
    axes_[i].values.resize(axes_[i].shown.size());
  }
}

/// All that an axis shows in PDOs, but its statusword and what it echoes.
void DriveFaults::add_actual_values(std::size_t axis) {
  const std::uint16_t first = object::on_axis(kFirstProfileObject, axis + 1);
  const std::uint16_t statusword = object::on_axis(object::kStatusword, axis + 1);
  for (const canopen::Entry& entry : dictionary_.entries()) {
    const bool is_of_axis = entry.index >= first && entry.index < object::on_axis(kFirstProfileObject, axis + 2);
    if (is_of_axis && entry.transmit_mappable && !entry.writable && entry.index != statusword)
      axes_[axis].shown.push_back(&entry);
  }
}

void DriveFaults::put_in(bool in) noexcept {
  if (in == is_in_) return;
  is_in_ = in;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    axes_[i].controlword.reset();
    axes_[i].is_frozen = false;
    device_.spoil(i + 1, {});
  }
  device_.runner().replace(in ? inner_ : *this, in ? static_cast<unit::Face&>(*this) : inner_);
}

void DriveFaults::run_cycles(canopen::TimePoint now) noexcept {
  if (!device_.is_on()) return;
  device_.tell_time(now);
  device_.runner().wake();
}

/// While cycles are counted there is no rest, nor before one has shown that a fault is over.
unit::AxisMask DriveFaults::waiting() const noexcept {
  const auto counts = [](const Loaded& loaded) {
    const When& when = loaded.fault.when;
    const bool is_counted = loaded.fault.kind->own == EventKind::Cycle ||
                            (when.event && when.event->kind == EventKind::Cycle) ||
                            (when.until && when.until->event.kind == EventKind::Cycle);
    return loaded.was_hit || (is_counted && loaded.trigger.phase() != Phase::Over);
  };
  return std::ranges::any_of(loaded_, counts) ? unit::kAllAxes : inner_.waiting();
}

void DriveFaults::bring() noexcept {
  inner_.bring();
  listener_.on_cycle();
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (!device_.spoil(i + 1, defect_of(i))) change_controlword(i);
}

/// All that is wrong with the words of @p axis.
device::AxisDefect DriveFaults::defect_of(std::size_t axis) const noexcept {
  device::AxisDefect defect{};
  for (const Loaded& loaded : loaded_) {
    if (!is_of(loaded, axis)) continue;
    if (is(loaded, "drive.ignores-controlword")) defect.ignores_controlword = true;
    if (is(loaded, "drive.never")) {
      const Hindrance hindrance = hindrance_of(loaded.value(Argument::DriveState).value_or(0));
      defect.controlword_cleared |= hindrance.cleared;
      defect.controlword_set |= hindrance.set;
    }
    if (is(loaded, "drive.status-bit")) {
      const auto bit = static_cast<std::uint16_t>(1U << loaded.value(Argument::Bit).value_or(0));
      (loaded.value(Argument::Value).value_or(0) != 0 ? defect.statusword_set : defect.statusword_cleared) |= bit;
    }
  }
  return defect;
}

void DriveFaults::change_controlword(std::size_t axis) noexcept {
  const std::uint16_t brought = device_.runner().unit().axes()[axis].process_data().controlword;
  std::uint16_t wanted = brought;
  const auto ignores = [&](const Loaded& loaded) {
    return is(loaded, "drive.ignores-controlword") && is_of(loaded, axis);
  };
  auto& kept = axes_[axis].controlword;
  if (std::ranges::any_of(loaded_, ignores)) {
    wanted = kept.value_or(brought);
    kept = wanted;
  } else {
    kept.reset();
  }
  for (const Loaded& loaded : loaded_) {
    if (!is(loaded, "drive.never") || !is_of(loaded, axis)) continue;
    const Hindrance hindrance = hindrance_of(loaded.value(Argument::DriveState).value_or(0));
    wanted = static_cast<std::uint16_t>((wanted & ~unsigned{hindrance.cleared}) | hindrance.set);
  }
  if (wanted != brought) set_controlword(axis, wanted);
}

/// Wherever the wiring takes it from.
void DriveFaults::set_controlword(std::size_t axis, std::uint16_t controlword) noexcept {
  drive::Axis& drive = device_.runner().unit().axes()[axis];
  drive::ProcessDataImage& image = drive.process_data();
  image.controlword = controlword;
  const double index = object::on_axis(object::kControlword, axis + 1);
  bool is_placed = false;
  for (std::size_t i = 0; i < image.received.size(); ++i) {
    const auto mapped = device_.unit().read(drive.number(), kReceivedObjects, i);
    if (!mapped || drive::decode(*mapped) != index) continue;
    image.received[i] = controlword;
    is_placed = true;
  }
  if (!is_placed) image.unplaced.controlword = controlword;
}

void DriveFaults::show() noexcept {
  inner_.show();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto freezes = [&](const Loaded& loaded) { return is(loaded, "drive.frozen") && is_of(loaded, i); };
    if (std::ranges::any_of(loaded_, freezes))
      freeze(axes_[i]);
    else
      axes_[i].is_frozen = false;
    for (const Loaded& loaded : loaded_)
      if (is(loaded, "drive.status-bit") && is_of(loaded, i)) change_statusword(i, loaded);
  }
}

void DriveFaults::freeze(Axis& axis) noexcept {
  for (std::size_t i = 0; i < axis.shown.size(); ++i) {
    if (axis.is_frozen)
      dictionary_.set(*axis.shown[i], axis.values[i]);
    else
      axis.values[i] = dictionary_.stored(*axis.shown[i]);
  }
  axis.is_frozen = true;
}

void DriveFaults::change_statusword(std::size_t axis, const Loaded& fault) noexcept {
  const canopen::Entry* const entry = dictionary_.lookup(object::on_axis(object::kStatusword, axis + 1), 0);
  if (entry == nullptr) return;
  const std::int64_t bit = std::int64_t{1} << fault.value(Argument::Bit).value_or(0);
  const std::int64_t stored = dictionary_.stored(*entry);
  dictionary_.set(*entry, fault.value(Argument::Value).value_or(0) != 0 ? stored | bit : stored & ~bit);
}

}  // namespace injection
