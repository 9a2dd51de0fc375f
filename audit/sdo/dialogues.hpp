#pragma once

#include <map>
#include <optional>

#include "audit/base/findings.hpp"
#include "audit/sdo/dialogue.hpp"

namespace audit {

/// The dialogues of all channels of SDO.
class Dialogues {
 public:
  explicit Dialogues(bool has_times) noexcept : has_times_{has_times} {}

  /// Takes the next frame of the bus; the transfer that it ends.
  std::optional<Transfer> take(const Passage& passage, Findings& findings);
  /// There are no more frames; @p at: when the last one came.
  void end(canopen::Duration at, Findings& findings);

 private:
  void reset(const Heard& heard, Findings& findings);
  void forget(std::uint8_t node);
  Dialogue& dialogue(const meaning::Meaning& meaning);

  bool has_times_;
  std::map<meaning::SdoChannel, Dialogue> dialogues_;
};

}  // namespace audit
