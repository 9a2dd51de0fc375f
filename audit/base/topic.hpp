#pragma once

#include "audit/base/findings.hpp"
#include "audit/base/heard.hpp"
#include "audit/base/time_lines.hpp"

namespace audit {

class Network;
struct Transfer;

/// What a topic is told with, and where it puts what it finds.
struct Scene {
  const Network& network;  ///< as it was before the frame
  Findings& findings;
  TimeLines& time_lines;
  std::uint64_t found_before = 0;  ///< findings before the transfer that is told
};

/// A part of what masters do: it looks at frames and at the transfers of SDO, and knows rules.
class Topic {
 public:
  Topic() = default;
  Topic(const Topic&) = delete;
  Topic& operator=(const Topic&) = delete;
  virtual ~Topic() = default;

  /// Each frame, error frames among them.
  virtual void on_frame(const Passage&, const Scene&) {}
  /// A transfer of SDO that ends with the frame that was told last.
  virtual void on_transfer(const Transfer&, const Scene&) {}
  /// There are no more frames; @p at: when the last one came.
  virtual void on_end(canopen::Duration, const Scene&) {}
};

}  // namespace audit
