#include "audit/error_control/error_control_topic.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "audit/base/transfer.hpp"
#include "audit/error_control/error_control_rules.hpp"
#include "libcanopen/base/object_index.hpp"

namespace audit {

namespace rules = error_control_rules;
namespace object = canopen::object;

using meaning::Role;

namespace {

constexpr std::int64_t kPeriodsOfLoss = 3;  // of silence, behind which a node is lost
constexpr std::uint64_t kUnsigned16 = 0xFFFF;
constexpr unsigned kSureIntervals = 3;  // of heartbeats, which tell their period
constexpr canopen::Duration kTimeToNotice = std::chrono::seconds{1};
/// Time after which a heartbeat that is waited for should have come.
constexpr canopen::Duration kPatience = std::chrono::seconds{5};

std::int64_t whole_milliseconds(canopen::Duration time) noexcept {
  return std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
}

/// Whether @p frame begins a transfer that writes.
bool is_download(const canopen::Frame& frame) noexcept {
  const auto request = canopen::sdo::CommandByte{frame.data[0]}.request();
  return request == canopen::sdo::Request::InitiateDownload || request == canopen::sdo::Request::BlockDownload;
}

canopen::Duration life_time(const Node& node) {
  const auto guard = node.value(object::kGuardTime, 0), factor = node.value(object::kLifeTimeFactor, 0);
  return std::chrono::milliseconds{static_cast<std::int64_t>(guard.value_or(0) * factor.value_or(0))};
}

}  // namespace

void ErrorControlTopic::on_frame(const Passage& passage, const Scene& scene) {
  if (passage.heard.is_error) return;
  switch (passage.meaning.role) {
    case Role::ErrorControl:
      return take_heartbeat(passage, scene);
    case Role::Guarding:
      return take_guarding(passage, scene);
    case Role::Nmt:
      return take_command(passage, scene);
    case Role::Rpdo:
    case Role::SdoRequest:
      return take_sending(passage, scene);
    default:
      return;
  }
}

void ErrorControlTopic::take_heartbeat(const Passage& passage, const Scene& scene) {
  Course& course = courses_[passage.meaning.node];
  const bool is_boot_up = passage.is_boot_up();
  course.unanswered = 0;
  if (std::exchange(course.is_guarded, false) && !is_boot_up) {  // an answer is no heartbeat
    course.answer = passage.heard;
    course.is_lost = false;
    return;
  }
  const std::optional<Heard> last = std::exchange(course.heartbeat, passage.heard);
  course.is_lost = false;
  if (is_boot_up) {
    course.forget_period();
    course.forget_guarding();
    course.both.reset();
    std::erase_if(waits_, [&](const Wait& wait) { return wait.consumer == passage.meaning.node; });
  }
  if (!last || !judges_times_ || is_boot_up) return;
  const canopen::Duration interval = passage.at() - last->at;
  course.period = std::max(course.period, interval);
  ++course.intervals;
  for (const Wait& wait : waits_) {
    const bool has_begun = last->place > wait.told.place && last->frame.data[0] != 0;  // with a heartbeat
    if (wait.producer != passage.meaning.node || interval <= wait.time || !has_begun) continue;
    scene.findings.add(rules::kHeartbeatLate, wait.consumer, {*last, passage.heard}, [&] {
      return fmt::format("that of node {} comes after {} ms, node {} waits {} ms", wait.producer,
                         whole_milliseconds(interval), wait.consumer, whole_milliseconds(wait.time));
    });
  }
}

/// A start judges what was told, a reset takes it away.
void ErrorControlTopic::take_command(const Passage& passage, const Scene& scene) {
  const std::uint8_t node = passage.frame().data[1];
  if (passage.is_start()) judge_settings(node, scene);
  if (!passage.is_reset()) return;
  for (std::size_t i = 1; i < courses_.size(); ++i)
    if (node == 0 || node == i) {
      courses_[i].forget_guarding();
      courses_[i].both.reset();
      courses_[i].forget_period();
    }
  std::erase_if(waits_, [node](const Wait& wait) { return node == 0 || wait.consumer == node; });
}

void ErrorControlTopic::take_guarding(const Passage& passage, const Scene& scene) {
  const Node& node = scene.network.node(passage.meaning.node);
  Course& course = courses_[node.id];
  const std::optional<Heard> last = std::exchange(course.guarding, passage.heard);
  if (std::exchange(course.is_guarded, true)) ++course.unanswered;
  if (node.value(object::kHeartbeatTime, 0).value_or(0) != 0)
    return scene.findings.add(
        rules::kGuardsHeartbeat, node.id, {course.heartbeat.value_or(passage.heard), passage.heard},
        [&] { return fmt::format("1017h has {} ms", *node.value(object::kHeartbeatTime, 0)); });
  const canopen::Duration life = life_time(node);
  if (!last || !judges_times_ || life == canopen::Duration{} || passage.at() - last->at <= life) return;
  scene.findings.add(rules::kLifeTime, node.id, {*last, passage.heard}, [&] {
    return fmt::format("after {} ms, the life time is {} ms", whole_milliseconds(passage.at() - last->at),
                       whole_milliseconds(life));
  });
}

/// The master tells a node something.
void ErrorControlTopic::take_sending(const Passage& passage, const Scene& scene) {
  const bool only_asks = passage.meaning.role == Role::SdoRequest && !is_download(passage.frame());
  if (only_asks) return;  // whether it is there
  if (judges_times_) look_for_end(passage, scene);
  Course& course = courses_[passage.meaning.node];
  const Node& node = scene.network.node(passage.meaning.node);
  const bool is_silent_by_order = node.values.find(object::kHeartbeatTime, 0) == 0;
  if (course.is_lost) return;
  if (course.answer && course.unanswered >= kPeriodsOfLoss && passage.at() - course.answer->at > kTimeToNotice) {
    course.is_lost = true;
    return scene.findings.add(rules::kLost, node.id, {*course.answer, passage.heard}, [&] {
      return fmt::format("{} times no answer of node guarding", course.unanswered);
    });
  }
  if (course.intervals < kSureIntervals || is_silent_by_order) return;
  const canopen::Duration silence = passage.at() - course.heartbeat->at;
  if (silence < course.period * kPeriodsOfLoss + kTimeToNotice) return;
  course.is_lost = true;
  scene.findings.add(rules::kLost, node.id, {*course.heartbeat, passage.heard}, [&] {
    return fmt::format("no heartbeat for {} ms, before each {} ms", whole_milliseconds(silence),
                       whole_milliseconds(course.period));
  });
}

/// A heartbeat of the master, or its node guarding, that has ended while it goes on.
void ErrorControlTopic::look_for_end(const Passage& passage, const Scene& scene) {
  const Node& node = scene.network.node(passage.meaning.node);
  Course& course = courses_[node.id];
  const canopen::Duration life = life_time(node);
  const bool has_ended =
      course.guarding && life != canopen::Duration{} && passage.at() - course.guarding->at > life + kTimeToNotice;
  if (has_ended)
    scene.findings.add(
        rules::kLifeTime, node.id, {*std::exchange(course.guarding, std::nullopt), passage.heard},
        [&] { return fmt::format("it has ended, the life time is {} ms", whole_milliseconds(life)); });
  for (Wait& wait : waits_) {
    const Node& producer = scene.network.node(wait.producer);
    const auto& last = courses_[wait.producer].heartbeat;
    const bool is_slave = producer.values.size() != 0 || producer.seen_tpdos != 0;  // its loss is no mistake
    if (wait.consumer != node.id || is_slave || wait.is_end_said || !last || last->place < wait.told.place)
      continue;
    wait.is_end_said = passage.at() - last->at > wait.time + kTimeToNotice;
    if (wait.is_end_said)
      scene.findings.add(rules::kHeartbeatLate, node.id, {*last, passage.heard}, [&] {
        return fmt::format("that of node {} has ended, node {} waits {} ms", wait.producer, node.id,
                           whole_milliseconds(wait.time));
      });
  }
}

void ErrorControlTopic::on_transfer(const Transfer& transfer, const Scene& scene) {
  if (!transfer.is_write || transfer.end == Transfer::End::AbortedByClient) return;
  take_both(transfer, scene);
  if (!transfer.is_done()) return;
  if (transfer.at.index == object::kHeartbeatTime) take_producer(transfer);
  if (transfer.at.index == object::kConsumerHeartbeatTime && transfer.at.sub_index != 0) take_consumer(transfer);
}

/// Whether heartbeat and node guarding are set, once @p transfer has its effect. A node may refuse that.
void ErrorControlTopic::take_both(const Transfer& transfer, const Scene& scene) {
  const Node& node = scene.network.node(transfer.channel.node);
  const std::array objects{object::kHeartbeatTime, object::kGuardTime, object::kLifeTimeFactor};
  if (std::ranges::find(objects, transfer.at.index) == objects.end()) return;
  const bool has_all = std::ranges::all_of(objects, [&](std::uint16_t index) {
    return (index == transfer.at.index ? transfer.value : node.value(index, 0).value_or(0)) != 0;
  });
  Course& course = courses_[node.id];
  course.both = has_all && transfer.is_done() ? std::optional{transfer} : std::nullopt;
  if (has_all && !transfer.is_done()) report_both(transfer, scene);
  if (transfer.is_done() && transfer.at.index != object::kHeartbeatTime) course.forget_guarding();  // begins anew
}

void ErrorControlTopic::take_consumer(const Transfer& transfer) {
  const Wait wait{.consumer = transfer.channel.node,
                  .producer = static_cast<std::uint8_t>(transfer.value >> 16 & 0x7F),
                  .sub_index = transfer.at.sub_index,
                  .time = std::chrono::milliseconds{static_cast<std::int64_t>(transfer.value & 0xFFFF)},
                  .told = transfer.request};
  std::erase_if(waits_, [&](const Wait& each) {
    return each.consumer == wait.consumer && each.sub_index == wait.sub_index;
  });
  if (wait.time != canopen::Duration{} && wait.producer != 0) waits_.push_back(wait);
}

void ErrorControlTopic::take_producer(const Transfer& transfer) {
  Course& producer = courses_[transfer.channel.node];
  producer.forget_period();
  producer.produces = transfer.request;
  for (Wait& wait : waits_)
    if (wait.producer == transfer.channel.node) wait.is_judged = false;
}

/// Times are set in any order: they are judged when @p node (0: each) is started, and at the end.
void ErrorControlTopic::judge_settings(std::uint8_t node, const Scene& scene) {
  judge_waits(node, scene);
  for (Course& course : courses_) {
    const auto id = static_cast<std::uint8_t>(&course - courses_.data());
    if (!course.both || (node != 0 && node != id)) continue;
    report_both(*std::exchange(course.both, std::nullopt), scene);
  }
}

void ErrorControlTopic::report_both(const Transfer& transfer, const Scene& scene) {
  scene.findings.add(rules::kBoth, transfer.channel.node, {transfer.request, transfer.last},
                     [] { return std::string{"1017h and 100Ch are not 0"}; });
}

/// The times of heartbeats that @p consumer (0: each) is started, and at the end.
void ErrorControlTopic::judge_waits(std::uint8_t consumer, const Scene& scene) {
  for (Wait& wait : waits_) {
    if ((consumer != 0 && consumer != wait.consumer) || std::exchange(wait.is_judged, true)) continue;
    const auto produced =
        scene.network.node(wait.producer).value(object::kHeartbeatTime, 0).value_or(0) & kUnsigned16;
    if (produced == 0 || whole_milliseconds(wait.time) > static_cast<std::int64_t>(produced)) continue;
    const auto words = [&] {
      return fmt::format("node {} sends each {} ms, node {} waits {} ms", wait.producer, produced, wait.consumer,
                         whole_milliseconds(wait.time));
    };
    const auto& produces = courses_[wait.producer].produces;
    if (!produces)
      scene.findings.add(rules::kConsumerShorter, wait.consumer, {wait.told}, words);
    else if (produces->place < wait.told.place)
      scene.findings.add(rules::kConsumerShorter, wait.consumer, {*produces, wait.told}, words);
    else
      scene.findings.add(rules::kConsumerShorter, wait.consumer, {wait.told, *produces}, words);
  }
}

void ErrorControlTopic::on_end(canopen::Duration at, const Scene& scene) {
  judge_settings(0, scene);
  if (!judges_times_) return;
  for (const Wait& wait : waits_)
    if (!courses_[wait.producer].heartbeat && at - wait.told.at >= kPatience)
      scene.findings.add(rules::kNobody, wait.consumer, {wait.told},
                         [&] { return fmt::format("node {}", wait.producer); });
}

}  // namespace audit
