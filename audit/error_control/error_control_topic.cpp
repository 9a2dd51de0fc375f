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
constexpr unsigned kSureIntervals = 3;      // of heartbeats, which tell their period
constexpr canopen::Duration kTimeToNotice = std::chrono::seconds{1};
/// Time after which a heartbeat that is waited for should have come.
constexpr canopen::Duration kPatience = std::chrono::seconds{5};

std::int64_t whole_milliseconds(canopen::Duration time) noexcept {
  return std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
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
  if (std::exchange(course.is_guarded, false) && !is_boot_up) return;  // an answer is no heartbeat
  const std::optional<Heard> last = std::exchange(course.heartbeat, passage.heard);
  course.is_lost = false;
  if (is_boot_up) {
    course.forget_period();
    course.guarding.reset();
    std::erase_if(waits_, [&](const Wait& wait) { return wait.consumer == passage.meaning.node; });
  }
  if (!last || !judges_times_ || is_boot_up) return;
  const canopen::Duration interval = passage.at() - last->at;
  course.period = std::max(course.period, interval);
  ++course.intervals;
  for (const Wait& wait : waits_) {
    if (wait.producer != passage.meaning.node || interval <= wait.time) continue;
    scene.findings.add(rules::kHeartbeatLate, wait.consumer, {*last, passage.heard}, [&] {
      return fmt::format("that of node {} comes after {} ms, node {} waits {} ms", wait.producer,
                         whole_milliseconds(interval), wait.consumer, whole_milliseconds(wait.time));
    });
  }
}

/// A start judges what was told, a reset takes it away.
void ErrorControlTopic::take_command(const Passage& passage, const Scene& scene) {
  const std::uint8_t node = passage.frame().data[1];
  if (passage.is_start()) judge_waits(node, scene);
  if (!passage.is_reset()) return;
  for (std::size_t i = 1; i < courses_.size(); ++i)
    if (node == 0 || node == i) {
      courses_[i].guarding.reset();
      courses_[i].forget_period();
    }
  std::erase_if(waits_, [node](const Wait& wait) { return node == 0 || wait.consumer == node; });
}

void ErrorControlTopic::take_guarding(const Passage& passage, const Scene& scene) {
  const Node& node = scene.network.node(passage.meaning.node);
  Course& course = courses_[node.id];
  const std::optional<Heard> last = std::exchange(course.guarding, passage.heard);
  course.is_guarded = true;
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

/// The master sends something to a node.
void ErrorControlTopic::take_sending(const Passage& passage, const Scene& scene) {
  Course& course = courses_[passage.meaning.node];
  const Node& node = scene.network.node(passage.meaning.node);
  const bool is_silent_by_order = node.values.find(object::kHeartbeatTime, 0) == 0;
  if (course.is_lost || course.intervals < kSureIntervals || is_silent_by_order) return;
  const canopen::Duration silence = passage.at() - course.heartbeat->at;
  if (silence < course.period * kPeriodsOfLoss + kTimeToNotice) return;
  course.is_lost = true;
  scene.findings.add(rules::kLost, node.id, {*course.heartbeat, passage.heard}, [&] {
    return fmt::format("no heartbeat for {} ms, before each {} ms", whole_milliseconds(silence),
                       whole_milliseconds(course.period));
  });
}

void ErrorControlTopic::on_transfer(const Transfer& transfer, const Scene& scene) {
  if (!transfer.is_write || transfer.end == Transfer::End::AbortedByClient) return;
  const Node& node = scene.network.node(transfer.channel.node);
  const bool heartbeat = transfer.at.index == object::kHeartbeatTime;
  const bool guarding = transfer.at.index == object::kGuardTime || transfer.at.index == object::kLifeTimeFactor;
  const bool has_heartbeat = heartbeat || node.value(object::kHeartbeatTime, 0).value_or(0) != 0;
  const bool has_guarding = guarding || life_time(node) != canopen::Duration{};
  if ((heartbeat || guarding) && transfer.value != 0 && has_heartbeat && has_guarding)
    scene.findings.add(rules::kBoth, node.id, {transfer.request, transfer.last},
                       [] { return std::string{"1017h and 100Ch are not 0"}; });
  if (!transfer.is_done()) return;
  if (heartbeat) take_producer(transfer);
  if (transfer.at.index == object::kConsumerHeartbeatTime && transfer.at.sub_index != 0) take_consumer(transfer);
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

/// Times are set in any order: they are judged when @p consumer (0: each) is started, and at the end.
void ErrorControlTopic::judge_waits(std::uint8_t consumer, const Scene& scene) {
  for (Wait& wait : waits_) {
    if ((consumer != 0 && consumer != wait.consumer) || std::exchange(wait.is_judged, true)) continue;
    const auto produced = scene.network.node(wait.producer).value(object::kHeartbeatTime, 0).value_or(0);
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
  judge_waits(0, scene);
  if (!judges_times_) return;
  for (const Wait& wait : waits_)
    if (!courses_[wait.producer].heartbeat && at - wait.told.at >= kPatience)
      scene.findings.add(rules::kNobody, wait.consumer, {wait.told},
                         [&] { return fmt::format("node {}", wait.producer); });
}

}  // namespace audit
