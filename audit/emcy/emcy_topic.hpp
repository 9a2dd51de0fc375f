#pragma once

#include <array>
#include <map>
#include <optional>

#include "audit/base/topic.hpp"
#include "audit/network/network.hpp"

namespace audit {

/// What a master does when a node reports an error.
class EmcyTopic final : public Topic {
 public:
  void on_frame(const Passage& passage, const Scene& scene) override;

 private:
  /// An error that was reported, and what has come since.
  struct Open {
    Heard emergency{};
    unsigned repetitions = 0;  ///< RPDOs that go on as before
  };

  void take_emergency(const Passage& passage, const Scene& scene);
  void take_rpdo(const Passage& passage, const Scene& scene);
  bool reacts(const canopen::Frame& before, const Passage& passage, const Network& network) const;
  [[nodiscard]] bool has_controlword(const Node& node) const;

  std::array<std::optional<Open>, Network::kNodes> open_{};
  std::map<meaning::Meaning, canopen::Frame> rpdos_;  ///< the last one of each
};

}  // namespace audit
