#include "audit/sync/sync_topic.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "audit/base/transfer.hpp"
#include "audit/network/pdo_record.hpp"
#include "audit/sync/sync_rules.hpp"
#include "libcanopen/base/object_index.hpp"

namespace audit {

namespace rules = sync_rules;
namespace object = canopen::object;

namespace {

constexpr std::size_t kIntervals = 8;      // of which the median is the period
constexpr std::int64_t kWidestSpread = 4;  // the longest of them is so many times the shortest
constexpr std::int64_t kPausePeriods = 10;
constexpr std::size_t kFew = 3;  // intervals that may be odd by chance
constexpr std::int64_t kJitterShare = 5;
constexpr std::int64_t kPeriodShare = 20;  // by which the period may be another than that of 1006h
constexpr std::uint64_t kLastSynchronousType = 240;
constexpr std::uint64_t kSeveral = 2;  // SYNC that show a producer
/// SYNC that begins again behind such a pause may have been set anew, and a producer is at work no more.
constexpr canopen::Duration kPause = std::chrono::seconds{1};
/// A node that was started so long ago should have heard SYNC.
constexpr canopen::Duration kPatience = std::chrono::seconds{3};

bool is_near(canopen::Duration time, canopen::Duration wanted, std::int64_t share) noexcept {
  return std::llabs((time - wanted).count()) <= wanted.count() / share;
}

bool is_synchronous(const Node& node, const PdoRecord& record) {
  const auto type = node.value(record.communication(), kTypeSub);
  return type && *type <= kLastSynchronousType;
}

bool is_of_master(meaning::Role role) noexcept {
  return role == meaning::Role::Nmt || role == meaning::Role::SdoRequest || role == meaning::Role::Rpdo;
}

}  // namespace

void SyncTopic::on_frame(const Passage& passage, const Scene& scene) {
  if (passage.heard.is_error) return;
  if (is_of_master(passage.meaning.role)) last_of_master_ = passage.heard;
  if (passage.meaning.role == meaning::Role::Nmt) last_setting_ = passage.heard.place;
  if (passage.meaning.role == meaning::Role::Sync && !passage.frame().remote) take_sync(passage.heard, scene);
  if (passage.meaning.role == meaning::Role::Rpdo && last_ && judges_times_) take_rpdo(passage, scene);
}

void SyncTopic::take_sync(const Heard& heard, const Scene& scene) {
  const canopen::Frame& frame = heard.frame;
  const bool is_other = last_ && last_->frame.length != frame.length && heard.at - last_->at < kPause &&
                        last_->place > last_setting_;
  if (frame.length > 1 || is_other)
    scene.findings.add(rules::kLength, 0, {last_.value_or(heard), heard},
                       [&] { return fmt::format("{} bytes", frame.length); });
  else if (last_ && frame.length == 1 && frame.data[0] != last_->frame.data[0] + 1 && frame.data[0] != 1)
    scene.findings.add(rules::kCounter, 0, {*last_, heard},
                       [&] { return fmt::format("{} behind {}", frame.data[0], last_->frame.data[0]); });
  if (frame.length == 1 && frame.data[0] > highest_count_) judge_count(heard, scene);
  if (frame.length == 1 && frame.data[0] == 1) judge_wrap(heard, scene);
  if (last_ && judges_times_) take_interval({*last_, heard}, scene);
  judge_settings(heard, scene);
  last_ = heard;
  ++count_;
}

/// What was set before the last SYNC, when there were enough since.
void SyncTopic::judge_settings(const Heard& heard, const Scene& scene) {
  if (until_length_ != 0 && --until_length_ == 0) judge_length(heard, scene);
  if (until_period_ != 0 && --until_period_ == 0 && last_ && period_ != canopen::Duration{})
    judge_period({*last_, heard}, scene);
}

/// With a counter, or without.
void SyncTopic::judge_length(const Heard& heard, const Scene& scene) {
  for (const Node& node : scene.network.nodes()) {
    const auto overflow = node.values.find(object::kSyncOverflow, 0);
    const bool is_wanted = heard.frame.length == (overflow.value_or(0) == 0 ? 0 : 1);
    if (overflow && !is_wanted && heard.frame.length <= 1)
      scene.findings.add(rules::kLength, node.id, {heard},
                         [&] { return fmt::format("{} bytes, 1019h has {}", heard.frame.length, *overflow); });
  }
}

/// A count of 1. One that comes early begins anew, and does not do so each time.
void SyncTopic::judge_wrap(const Heard& heard, const Scene& scene) {
  constexpr unsigned kTwice = 2;
  if (!last_ || last_->frame.length != 1 || overflow_ == 0) return;
  const std::uint8_t before = last_->frame.data[0];
  early_wraps_ = before < overflow_ ? early_wraps_ + 1 : 0;
  if (early_wraps_ == kTwice)
    scene.findings.add(rules::kCounter, 0, {*last_, heard},
                       [&] { return fmt::format("1 behind {}, 1019h has {}", before, overflow_); });
}

/// A count that is higher than each before.
void SyncTopic::judge_count(const Heard& heard, const Scene& scene) {
  highest_count_ = heard.frame.data[0];
  for (const Node& node : scene.network.nodes()) {
    const auto overflow = node.value(object::kSyncOverflow, 0).value_or(0);
    if (overflow != 0 && highest_count_ > overflow)
      scene.findings.add(rules::kCounter, node.id, {last_.value_or(heard), heard},
                         [&] { return fmt::format("{}, 1019h has {}", highest_count_, overflow); });
  }
}

void SyncTopic::take_interval(const Interval& interval, const Scene& scene) {
  if (interval.begin.place < last_setting_) return;  // it was stopped, or set anew
  if (period_ == canopen::Duration{}) return take_first_interval(interval, scene);
  if (is_near(interval.length(), period_, kJitterShare)) return report_odd_intervals(scene);
  const bool begins_anew = interval.end.frame.length == 1 && interval.end.frame.data[0] == 1;
  if (interval.length() < period_ * kPausePeriods && !begins_anew) take_odd_interval(interval, scene);
}

/// Whoever sends SYNC now and then, by hand or in a burst, has no period.
void SyncTopic::take_first_interval(const Interval& interval, const Scene& scene) {
  first_.push_back(interval);
  if (first_.size() < kIntervals) return;
  const auto [shortest, longest] = std::ranges::minmax_element(first_, {}, &Interval::length);
  if (longest->length() <= shortest->length() * kWidestSpread) {
    period_ = median(first_);
    judge_period(interval, scene);
  }
  first_.erase(first_.begin());
}

/// Several of one length are a new period, not jitter.
void SyncTopic::take_odd_interval(const Interval& interval, const Scene& scene) {
  odd_.push_back(interval);
  if (odd_.size() < kIntervals) return;
  if (!are_alike(odd_)) return report_odd_intervals(scene);
  period_ = median(odd_);
  odd_.clear();
  judge_period(interval, scene);
}

void SyncTopic::report_odd_intervals(const Scene& scene) {
  for (const Interval& odd : odd_)
    scene.findings.add(rules::kJitter, 0, {odd.begin, odd.end}, [&] {
      return fmt::format("{:.3f} ms instead of {:.3f} ms", milliseconds(odd.length()), milliseconds(period_));
    });
  odd_.clear();
}

canopen::Duration SyncTopic::median(std::vector<Interval> intervals) {
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::ranges::nth_element(intervals, middle, {}, &Interval::length);
  return middle->length();
}

bool SyncTopic::are_alike(const std::vector<Interval>& intervals) {
  const canopen::Duration middle = median(intervals);
  return std::ranges::all_of(
      intervals, [middle](const Interval& interval) { return is_near(interval.length(), middle, kJitterShare); });
}

void SyncTopic::judge_period(const Interval& last, const Scene& scene) {
  until_period_ = 0;
  for (const Node& node : scene.network.nodes()) {
    const auto told = node.is_there ? node.value(object::kCyclePeriod, 0) : std::nullopt;
    if (!told || *told == 0) continue;
    const auto wanted = std::chrono::microseconds{static_cast<std::int64_t>(*told)};
    if (!is_near(period_, wanted, kPeriodShare))
      scene.findings.add(rules::kPeriod, node.id, {last.begin, last.end}, [&] {
        return fmt::format("{:.3f} ms, 1006h has {:.3f} ms", milliseconds(period_), milliseconds(wanted));
      });
  }
}

void SyncTopic::take_rpdo(const Passage& passage, const Scene& scene) {
  const Node& node = scene.network.node(passage.meaning.node);
  const auto window = node.value(object::kWindowLength, 0);
  if (!window || *window == 0 || !is_synchronous(node, {.is_receive = true, .number = passage.meaning.number}))
    return;
  const canopen::Duration since = passage.at() - last_->at;
  if (since > std::chrono::microseconds{static_cast<std::int64_t>(*window)})
    scene.findings.add(rules::kWindow, node.id, {*last_, passage.heard}, [&] {
      return fmt::format("RPDO {}: {:.3f} ms behind SYNC, 1007h has {} us", passage.meaning.number,
                         milliseconds(since), *window);
    });
}

/// What SYNC is to be like, as @p transfer has told it.
void SyncTopic::take_setting(const Transfer& transfer) {
  if (!transfer.is_done() || transfer.at.sub_index != 0) return;
  const std::uint16_t index = transfer.at.index;
  if (index == object::kSyncOverflow) {
    overflow_ = transfer.value;
    highest_count_ = 0;
    early_wraps_ = 0;
    until_length_ = kSettled;
  }
  if (index == object::kCyclePeriod) until_period_ = kSettled;
  const bool is_of_sync =
      index == object::kCobIdSync || index == object::kCyclePeriod || index == object::kSyncOverflow;
  if (transfer.is_write && is_of_sync) last_setting_ = transfer.request.place;
  const bool stops =
      transfer.is_written(object::kCobIdSync, 0) && (transfer.value & canopen::cob_id::kProduce) == 0;
  if (stops) count_ = 0;
}

void SyncTopic::on_transfer(const Transfer& transfer, const Scene& scene) {
  take_setting(transfer);
  if (!transfer.is_written(object::kCobIdSync, 0) || (transfer.value & canopen::cob_id::kProduce) == 0) return;
  const Node* other = nullptr;
  for (const Node& node : scene.network.nodes())
    if (node.id != transfer.channel.node &&
        (node.value(object::kCobIdSync, 0).value_or(0) & canopen::cob_id::kProduce))
      other = &node;
  // A node that is not known to have been silent may be the producer itself.
  const auto before = scene.network.node(transfer.channel.node).value(object::kCobIdSync, 0);
  const bool is_heard = count_ >= kSeveral && transfer.request.at - last_->at < kPause;
  const bool may_be_itself = !before || (*before & canopen::cob_id::kProduce) != 0;
  if (other == nullptr && (may_be_itself || !is_heard)) return;
  scene.findings.add(rules::kTwoProducers, transfer.channel.node,
                     {last_.value_or(transfer.request), transfer.request}, [&] {
                       return other == nullptr ? std::string{"SYNC comes already"}
                                               : fmt::format("node {} produces it, too", other->id);
                     });
}

void SyncTopic::on_end(canopen::Duration at, const Scene& scene) {
  if (odd_.size() < kFew || !are_alike(odd_)) report_odd_intervals(scene);
  if (!judges_times_) return;
  // Who ends and lets the nodes run has stopped SYNC rightly.
  const bool has_stopped = last_ && period_ != canopen::Duration{} && last_of_master_ &&
                           last_of_master_->at - last_->at >= kPatience + period_ * kPausePeriods;
  if (last_ && !has_stopped) return;
  for (const Node& node : scene.network.nodes()) {
    const bool runs = node.is_there && node.state == canopen::NmtState::Operational && node.told;
    if (runs && at - node.told->at >= kPatience) report_missing(node, scene);
  }
}

/// Synchronous PDOs that @p node has in use.
void SyncTopic::report_missing(const Node& node, const Scene& scene) const {
  for (std::uint16_t number = 1; number <= object::kRpdoMapping - object::kRpdoParameter; ++number)
    for (const bool is_receive : {true, false}) {
      const PdoRecord record{.is_receive = is_receive, .number = number};
      if (is_valid(node, record) != true || !is_synchronous(node, record)) continue;
      if (last_ && last_->place > node.told->place)
        scene.findings.add(rules::kMissing, node.id, {*node.told, *last_},
                           [&] { return name_of(record) + ", and SYNC has stopped"; });
      else
        scene.findings.add(rules::kMissing, node.id, {*node.told}, [&] { return name_of(record); });
    }
}

}  // namespace audit
