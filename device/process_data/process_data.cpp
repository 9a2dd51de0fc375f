#include "device/process_data/process_data.hpp"

#include <algorithm>
#include <type_traits>

namespace device {
namespace {

WordForm form_of(std::uint16_t index, const auto& objects) noexcept {
  if (index < object::kFirstProfileObject) return WordForm::Raw;
  const auto first = object::on_first_axis(index);
  const auto* const row = std::ranges::find(objects, first, [](const auto& candidate) { return candidate.index; });
  return row != objects.end() ? row->form : WordForm::Raw;
}

}  // namespace

ProcessData::ProcessData(canopen::Dictionary& dictionary, drive::Axis& axis, const ProcessDataBuffers& places)
    : dictionary_{dictionary},
      axis_{axis},
      places_{places},
      scaling_{dictionary, axis},
      controlword_index_{object::on_axis(object::kControlword, axis.axis_number())},
      controlword_{dictionary.cell<std::uint16_t>(controlword_index_, 0)} {
  for (const SentObject& sent : kSentObjects) sent_entries_.push_back(&entry(sent.index));
  received_.reserve(ProcessDataLayout::kReceiveWords);
  sent_.reserve(ProcessDataLayout::kTransmitWords);
  shown_.reserve(kSentObjects.size());
  written_.reserve(kReceivedObjects.size() + object::kFreeWords + object::kFreeDoubleWords);
}

const canopen::Entry& ProcessData::entry(std::uint16_t index) const {
  return **dictionary_.find(object::on_axis(index, axis_.axis_number()), 0);
}

WordScaling ProcessData::scaling() const noexcept {
  return {scaling_.get(), axis_.references()};
}

void ProcessData::plan() noexcept {
  if (version_ == places_.version()) return;
  received_.clear();
  for (const ProcessDataLayout::Item& item : places_.received().items())
    received_.push_back({item.object, form_of(item.object->index, kReceivedObjects), item.first, item.words});
  const auto* const mode =
      places_.received().find(object::on_axis(object::kModesOfOperation, axis_.axis_number()));
  mode_ = mode != nullptr ? mode->object : nullptr;
  controlword_placed_ = places_.received().find(controlword_index_) != nullptr;
  axis_.process_data().received = {};
  plan_sent();
  plan_written();
  version_ = places_.version();
}

void ProcessData::plan_sent() noexcept {
  sent_.clear();
  shown_.clear();
  for (const ProcessDataLayout::Item& item : places_.sent().items())
    sent_.push_back({item.object, form_of(item.object->index, kSentObjects), item.first, item.words});
  for (std::size_t i = 0; i < kSentObjects.size(); ++i)
    if (places_.sent().find(sent_entries_[i]->index) == nullptr)
      shown_.push_back({sent_entries_[i], &kSentObjects[i]});
}

void ProcessData::receive(std::uint16_t controlword) noexcept {
  plan();
  drive::ProcessDataImage& image = axis_.process_data();
  const WordScaling scaling = this->scaling();
  for (const Placed& item : received_) {
    const bool is_controlword = item.entry->index == controlword_index_;
    const std::int64_t bus = is_controlword ? controlword : dictionary_.stored(*item.entry);
    const std::uint32_t words = scaling.words(item.form, bus);
    if (item.words == 1)
      image.received[item.first] = static_cast<std::uint16_t>(words);
    else
      drive::ProcessDataImage::set_double_word(image.received, item.first, words);
  }
  image.controlword = controlword;
  image.requested_mode.reset();
  if (mode_ != nullptr) image.requested_mode = static_cast<std::int8_t>(dictionary_.stored(*mode_));
  axis_.scale_process_data({scaling_.get().per_radian(), axis_.references().rated_torque});
  image.unplaced.controlword = controlword_placed_ ? std::uint16_t{0} : controlword;
  for (const Written& item : written_) {
    const std::int64_t bus = dictionary_.stored(*item.entry);
    std::visit([&](auto* target) { *target = static_cast<std::remove_pointer_t<decltype(target)>>(bus); },
               item.target);
  }
}

/// Objects without a place lead to the parameters that stand for them; the parameter of one that has a place is 0.
void ProcessData::plan_written() noexcept {
  written_.clear();
  drive::ProcessDataImage::Unplaced& unplaced = axis_.process_data().unplaced;
  const std::size_t axis = axis_.axis_number();
  const auto add = [&](std::uint16_t index, auto& target) {
    target = 0;
    const canopen::Entry* const entry = dictionary_.lookup(index, 0);
    if (entry != nullptr && places_.received().find(index) == nullptr) written_.push_back({entry, &target});
  };
  add(object::on_axis(object::kVlTargetVelocity, axis), unplaced.speed_rpm);
  add(object::on_axis(object::kTargetVelocity, axis), unplaced.speed_increments);
  add(object::on_axis(object::kTargetTorque, axis), unplaced.torque);
  for (std::uint16_t i = 0; i < object::kFreeWords; ++i)
    add(static_cast<std::uint16_t>(object::free_on_axis(object::kReceiveWords, axis) + i), unplaced.words[i]);
  for (std::uint16_t i = 0; i < object::kFreeDoubleWords; ++i)
    add(static_cast<std::uint16_t>(object::free_on_axis(object::kReceiveDoubleWords, axis) + i),
        unplaced.double_words[i]);
}

void ProcessData::publish() noexcept {
  plan();
  const WordScaling scaling = this->scaling();
  const drive::ProcessDataImage& image = axis_.process_data();
  for (const Placed& item : sent_) {
    const std::uint32_t words =
        item.words == 1 ? image.sent[item.first] : drive::ProcessDataImage::double_word(image.sent, item.first);
    dictionary_.set(*item.entry, scaling.bus(item.form, words));
  }
  for (const Shown& item : shown_)
    dictionary_.set(*item.entry, scaling.bus_of(item.object->form, item.object->value(axis_.actual())));
}

}  // namespace device
