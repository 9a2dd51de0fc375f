#pragma once

#include <optional>

#include "audit/base/topic.hpp"

namespace audit {

/// How a master gives nodes their node-IDs.
class LssTopic final : public Topic {
 public:
  explicit LssTopic(bool judges_times) noexcept : judges_times_{judges_times} {}

  void on_frame(const Passage& passage, const Scene& scene) override;
  void on_end(canopen::Duration at, const Scene& scene) override;

 private:
  bool judges_times_;
  void take_command(const Heard& heard, const Scene& scene);
  void take_switch(const Heard& heard);
  void take_answer(const Heard& heard);
  void report_unanswered(const Scene& scene);
  void judge_configuration(const Heard& heard, const Scene& scene);

  canopen::Duration last_at_{};     ///< the last frame of LSS
  std::optional<Heard> switched_;   ///< the command that has switched nodes to configuration
  bool is_global_ = false;          ///< it was for all
  canopen::Frame last_{};           ///< the last command
  std::optional<Heard> asked_;      ///< what is not answered yet
  std::optional<Heard> to_nobody_;  ///< a configuration that is not answered, while no node is known to take it
};

}  // namespace audit
