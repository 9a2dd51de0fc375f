#pragma once

#include <array>
#include <optional>
#include <vector>

#include "audit/base/topic.hpp"
#include "audit/network/network.hpp"

namespace audit {

/// The SYNC of a bus: its period, its counter, and what goes with it.
class SyncTopic final : public Topic {
 public:
  /// @p judges_times: frames have times.
  explicit SyncTopic(bool judges_times) : judges_times_{judges_times} {}

  void on_frame(const Passage& passage, const Scene& scene) override;
  void on_transfer(const Transfer& transfer, const Scene& scene) override;
  void on_end(canopen::Duration at, const Scene& scene) override;

 private:
  /// Two SYNC, one behind the other.
  struct Interval {
    Heard begin{}, end{};

    [[nodiscard]] canopen::Duration length() const noexcept { return end.at - begin.at; }
  };

  /// SYNC behind a setting that may still be as before.
  static constexpr unsigned kSettled = 8;

  void take_sync(const Heard& heard, const Scene& scene);
  void take_interval(const Interval& interval, const Scene& scene);
  void take_first_interval(const Interval& interval, const Scene& scene);
  void take_odd_interval(const Interval& interval, const Scene& scene);
  void report_odd_intervals(const Scene& scene);
  void judge_period(const Interval& last, const Scene& scene);
  static canopen::Duration median(std::vector<Interval> intervals);
  static bool are_alike(const std::vector<Interval>& intervals);
  static void judge_length(const Heard& heard, const Scene& scene);
  void judge_count(const Heard& heard, const Scene& scene);
  void judge_wrap(const Heard& heard, const Scene& scene);
  void judge_settings(const Heard& heard, const Scene& scene);
  void take_setting(const Transfer& transfer);
  void report_missing(const Node& node, const Scene& scene) const;
  void take_rpdo(const Passage& passage, const Scene& scene);

  bool judges_times_;
  std::optional<Heard> last_;
  std::optional<Heard> last_of_master_;  ///< NMT command, SDO request or RPDO
  std::uint64_t last_setting_ = 0;       ///< place of the last NMT command, or write of what SYNC is to be like
  std::uint64_t overflow_ = 0;           ///< the last 1019h that was told
  std::uint8_t highest_count_ = 0;       ///< that was held against 1019h
  unsigned early_wraps_ = 0;             ///< of the counter, in a row
  unsigned until_length_ = kSettled;     ///< SYNC until its length is held against 1019h; 0: it was
  unsigned until_period_ = 0;            ///< SYNC until the period is held against 1006h; 0: it was
  std::uint64_t count_ = 0;
  canopen::Duration period_{};   ///< 0: not known yet
  std::vector<Interval> first_;  ///< the last ones, while the period is not known
  std::vector<Interval> odd_;    ///< those of another length since the last one that was as long as the period
};

}  // namespace audit
