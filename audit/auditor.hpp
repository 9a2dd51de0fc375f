#pragma once

#include <memory>
#include <vector>

#include "audit/base/findings.hpp"
#include "audit/base/topic.hpp"
#include "audit/network/network.hpp"
#include "audit/sdo/dialogues.hpp"
#include "meaning/cob_ids.hpp"

namespace audit {

/// What is known before the first frame.
struct Circumstances {
  std::vector<eds::Description> descriptions{};  ///< of nodes, each for its own
  std::uint32_t bit_rate = 0;                    ///< of the bus (bit/s); 0: not known
  bool has_times = true;                         ///< frames have times; else no rule of time is judged
  bool hears_all = true;  ///< else what one node hears: its own frames and what is sent to it
};

/// Judges what masters do by the frames of a bus, as they come. The memory that it takes is bounded.
class Auditor {
 public:
  explicit Auditor(Circumstances circumstances);
  Auditor(const Auditor&) = delete;
  Auditor& operator=(const Auditor&) = delete;
  ~Auditor();

  /// What @p description says holds for its node from now on.
  void describe(eds::Description description);
  /// Takes the next frame; times do not go back.
  void take(const Heard& heard);
  /// There are no more frames: what is open is judged.
  void end();

  [[nodiscard]] const Findings& findings() const noexcept { return findings_; }
  [[nodiscard]] const TimeLines& time_lines() const noexcept { return time_lines_; }
  [[nodiscard]] const Network& network() const noexcept { return network_; }
  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }

 private:
  [[nodiscard]] Passage passage_of(const Heard& heard) const;
  void judge(const Transfer& transfer);

  meaning::CobIds ids_;
  Network network_;
  Findings findings_;
  TimeLines time_lines_{};
  Dialogues dialogues_;
  std::vector<std::unique_ptr<Topic>> topics_;
  std::uint64_t frames_ = 0;
  canopen::Duration last_{};
};

}  // namespace audit
