#pragma once

#include <map>
#include <optional>

#include "audit/base/findings.hpp"
#include "audit/sdo/dialogue.hpp"

namespace audit {

/// The dialogues of all channels of SDO.
class Dialogues {
 public:
  /// Takes the next frame of the bus; the transfer that it ends.
  std::optional<Transfer> take(const Passage& passage, Findings& findings);
  /// There are no more frames; @p at: when the last one came.
  void end(canopen::Duration at, Findings& findings);

 private:
  void reset(const Heard& heard, Findings& findings);
  Dialogue& dialogue(const meaning::Meaning& meaning);

  std::map<meaning::SdoChannel, Dialogue> dialogues_;
};

}  // namespace audit
