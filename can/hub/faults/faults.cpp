#include "can/hub/faults/faults.hpp"

#include <algorithm>
#include <chrono>
#include <ranges>
#include <utility>

#include <fmt/format.h>

#include "can/hub/faults/limits.hpp"
#include "injection/kinds/bus_kinds.hpp"

namespace hub::faults {

using canopen::TimePoint;

namespace {

bool is_error_frame(const can_frame& frame) noexcept {
  return (frame.can_id & CAN_ERR_FLAG) != 0;
}

bool same_content(const can_frame& one, const can_frame& other) noexcept {
  return std::ranges::equal(one.data, other.data);
}

/// An object, or words; a text that is an object is one, too.
tl::expected<injection::Fault, injection::Problem> read(const nlohmann::json& said) {
  if (!said.is_string()) return injection::read_fault(said, injection::bus_kinds());
  const auto& text = said.get_ref<const std::string&>();
  if (!text.starts_with('{')) return injection::read_fault_words(text, injection::bus_kinds());
  const auto object = nlohmann::json::parse(text, nullptr, false);
  if (object.is_discarded())
    return tl::unexpected{injection::Problem{"", "words (bus.drop id=185) or JSON", text}};
  return injection::read_fault(object, injection::bus_kinds());
}

}  // namespace

/// The sender alone, or those whom no cut keeps from hearing it, with it or without.
class Faults::Hearers final : public Audience {
 public:
  enum class Who : std::uint8_t { Sender, Others, All };

  Hearers(const Faults& faults, const Passage& passage, const Identity& sender, Who who) noexcept
      : faults_{faults}, passage_{passage}, sender_{sender}, who_{who} {}

  [[nodiscard]] bool hears(const Participant& participant) const noexcept override {
    if (&participant == passage_.sender) return who_ != Who::Others;
    if (who_ == Who::Sender) return false;
    return faults_.cuts_.empty() || !faults_.is_parted(passage_.frame, sender_, participant.identity());
  }

 private:
  const Faults& faults_;
  const Passage& passage_;
  const Identity& sender_;
  Who who_;
};

Faults::~Faults() {
  medium_.set_interference(nullptr);
}

tl::expected<std::uint32_t, std::string> Faults::inject(const nlohmann::json& said, TimePoint now) {
  auto fault = read(said);
  if (!fault) return tl::unexpected{fault.error().message()};
  if (const auto problem = find_problem(*fault, medium_)) return tl::unexpected{problem->message()};
  if (faults_.size() >= kMost)
    return tl::unexpected{fmt::format("expected {} faults at most, take some of them back first", kMost)};
  faults_.reserve(kMost);
  cuts_.reserve(kMost);
  late_.reserve();
  auto loaded = std::make_unique<LoadedFault>(last_number_ + 1, *std::move(fault), medium_, interfaces_, now);
  faults_.push_back(std::move(loaded));
  if (!std::exchange(at_work_, true)) {
    own_bit_rate_ = medium_.bit_rate();
    medium_.set_interference(this);
  }
  return ++last_number_;
}

nlohmann::json Faults::list(TimePoint now) {
  nlohmann::json all = nlohmann::json::array();
  for (const auto& fault : faults_) {
    fault->on_time(now);
    all.push_back(fault->json());
  }
  return all;
}

std::size_t Faults::take_back(std::optional<std::uint32_t> number) noexcept {
  return std::erase_if(
      faults_, [number](const auto& fault) { return number.value_or(fault->number()) == fault->number(); });
}

void Faults::on_end(const Passage& passage, const Identity& sender, TimePoint end) noexcept {
  find_cuts(end);
  if (std::exchange(repeating_, false)) {
    given_.mark = passage.mark;
    given_.time_ns = passage.time_ns;
    return give_others(sender);
  }
  release(end);
  find_cuts(end);
  Fate fate{.heard = passage.frame};
  if (!is_error_frame(passage.frame))
    for (const auto& fault : faults_) fault->judge(passage, fate, end);
  hand_out(passage, fate, sender, end);
}

/// The sender hears its frame as it was sent, and no later.
void Faults::hand_out(const Passage& passage, const Fate& fate, const Identity& sender, TimePoint end) noexcept {
  using Who = Hearers::Who;
  const bool is_heard_now = !fate.lost && fate.delay == canopen::Duration::zero();
  const bool is_whole = is_heard_now && same_content(fate.heard, passage.frame);
  medium_.hand_out(passage, Hearers{*this, passage, sender, is_whole ? Who::All : Who::Sender});
  if (fate.lost) return;
  if (!is_heard_now) return keep(passage, fate, sender, end);
  given_ = passage;
  given_.frame = fate.heard;
  if (!is_whole) give_others(sender);
  if (!fate.twice) return;
  repeating_ = true;
  medium_.repeat();
}

void Faults::give_others(const Identity& sender) noexcept {
  medium_.hand_out(given_, Hearers{*this, given_, sender, Hearers::Who::Others});
}

void Faults::keep(const Passage& passage, const Fate& fate, const Identity& sender, TimePoint end) noexcept {
  LateFrames::Late late{.due = end + fate.delay, .passage = passage, .sender = sender};
  late.passage.frame = fate.heard;
  if (!late_.keep(late)) ++lost_;
  if (!fate.twice) return;
  late.passage.mark = medium_.new_mark();
  if (!late_.keep(late)) ++lost_;
}

void Faults::release(TimePoint now) noexcept {
  while (late_.next() <= now) {
    const LateFrames::Late late = late_.take();
    find_cuts(late.due);
    given_ = late.passage;
    given_.time_ns = medium_.clock().wall();
    give_others(late.sender);
  }
}

void Faults::find_cuts(TimePoint now) noexcept {
  cuts_.clear();
  for (const auto& fault : faults_)
    if (fault->is_cut(now)) cuts_.push_back(fault.get());
}

bool Faults::is_parted(const can_frame& frame, const Identity& one, const Identity& other) const noexcept {
  return std::ranges::any_of(cuts_, [&](const LoadedFault* cut) { return cut->parts(frame, one, other); });
}

void Faults::on_detach(const Participant& participant) noexcept {
  late_.forget(participant);
  if (given_.sender == &participant) given_.sender = nullptr;
}

/// That of the fault that came last; else the bus's own.
std::uint32_t Faults::wanted_bit_rate() const noexcept {
  std::uint32_t wanted = own_bit_rate_;
  for (const auto& fault : faults_)
    if (const std::uint32_t rate = fault->bit_rate(); rate != 0) wanted = rate;
  return wanted;
}

TimePoint Faults::next_deadline() const noexcept {
  if (faults_.empty() && late_.empty()) return medium_.now();  // to let go of the medium
  if (wanted_bit_rate() != medium_.bit_rate()) return medium_.now();
  TimePoint next = late_.next();
  for (const auto& fault : faults_) next = std::min(next, fault->next_deadline());
  return next;
}

void Faults::on_time(TimePoint now) noexcept {
  release(now);
  for (const auto& fault : faults_) fault->on_time(now);
  if (const std::uint32_t rate = wanted_bit_rate(); rate != medium_.bit_rate()) medium_.set_bit_rate(rate);
  if (!faults_.empty() || !late_.empty()) return;
  medium_.set_interference(nullptr);
  at_work_ = false;
}

}  // namespace hub::faults
