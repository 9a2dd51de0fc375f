#pragma once

#include <array>
#include <optional>
#include <vector>

#include "audit/base/topic.hpp"
#include "audit/base/transfer.hpp"
#include "audit/network/network.hpp"

namespace audit {

/// Heartbeat and node guarding: how they are set, and whether they come in time.
class ErrorControlTopic final : public Topic {
 public:
  /// @p judges_times: frames have times.
  explicit ErrorControlTopic(bool judges_times) : judges_times_{judges_times} {}

  void on_frame(const Passage& passage, const Scene& scene) override;
  void on_transfer(const Transfer& transfer, const Scene& scene) override;
  void on_end(canopen::Duration at, const Scene& scene) override;

 private:
  /// What is remembered of a node.
  struct Course {
    std::optional<Heard> heartbeat{};  ///< the last one
    canopen::Duration period{};        ///< the longest of the intervals between them since 1017h was written
    unsigned intervals = 0;            ///< how many that are
    std::optional<Heard> guarding{};   ///< the last remote frame
    bool is_guarded = false;           ///< it was not answered yet
    std::optional<Heard> answer{};     ///< the last one
    unsigned unanswered = 0;           ///< remote frames since it
    bool is_lost = false;              ///< said already
    std::optional<Heard> produces{};   ///< the request that has written 1017h last
    std::optional<Transfer> both{};    ///< has set heartbeat beside node guarding, or the other way round

    void forget_guarding() noexcept {
      guarding.reset();
      answer.reset();
      unanswered = 0;
    }
    void forget_period() noexcept {
      period = {};
      intervals = 0;
    }
  };

  /// A node that was told to wait for the heartbeat of another one.
  struct Wait {
    std::uint8_t consumer = 0, producer = 0;
    std::uint8_t sub_index = 0;  ///< of 1016h
    canopen::Duration time{};
    Heard told{};
    bool is_judged = false;    ///< since the time of consumer or producer was written
    bool is_end_said = false;  ///< that the heartbeat has ended
  };

  void take_heartbeat(const Passage& passage, const Scene& scene);
  void take_command(const Passage& passage, const Scene& scene);
  void take_guarding(const Passage& passage, const Scene& scene);
  void take_sending(const Passage& passage, const Scene& scene);
  void take_consumer(const Transfer& transfer);
  void take_producer(const Transfer& transfer);
  void take_both(const Transfer& transfer, const Scene& scene);
  void judge_settings(std::uint8_t node, const Scene& scene);
  void judge_waits(std::uint8_t consumer, const Scene& scene);
  static void report_both(const Transfer& transfer, const Scene& scene);
  void look_for_end(const Passage& passage, const Scene& scene);

  bool judges_times_;
  std::array<Course, Network::kNodes> courses_{};
  std::vector<Wait> waits_;
};

}  // namespace audit
