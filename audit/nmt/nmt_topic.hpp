#pragma once

#include <array>
#include <optional>

#include "audit/base/topic.hpp"
#include "audit/network/network.hpp"

namespace audit {

/// How a master leads nodes through their states.
class NmtTopic final : public Topic {
 public:
  /// @p hears_all: nodes that are not heard are not there; else commands to all nodes are not judged.
  explicit NmtTopic(bool hears_all) noexcept : hears_all_{hears_all} {}

  void on_frame(const Passage& passage, const Scene& scene) override;
  void on_end(canopen::Duration at, const Scene& scene) override;

 private:
  /// What is remembered of a node.
  struct Course {
    unsigned repetitions = 0;         ///< commands that were of no use, in a row
    std::optional<Heard> rebooted{};  ///< it has booted by itself, and nobody has cared
    bool was_started = false;
  };

  void take_command(const Passage& passage, const Scene& scene);
  void command(const Node& node, const Passage& passage, const Scene& scene, bool is_judged);
  void take_request(const Passage& passage, const Scene& scene);
  void take_error_control(const Passage& passage, const Scene& scene);
  void look_for_unnoticed(const Passage& passage, const Scene& scene);

  bool hears_all_;
  std::array<Course, Network::kNodes> courses_{};
  unsigned rebooted_ = 0;  ///< how many have Course::rebooted
};

}  // namespace audit
