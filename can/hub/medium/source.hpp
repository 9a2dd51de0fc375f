#pragma once

#include "can/userbus/protocol.hpp"
#include "libcanopen/base/time.hpp"

namespace hub {

/// What the hub's loop watches beside the members: a bridge, a server for another kind of client, a signal.
///
/// A source that takes part in the traffic is a Participant too and attaches itself to the Medium.
class Source {
 public:
  Source() = default;
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  virtual ~Source() = default;

  /// Descriptor that is watched for reading; it stays the same while the loop has the source.
  [[nodiscard]] virtual int descriptor() const noexcept = 0;
  /// The descriptor polls readable, or in error. Called again at once while it does: read some, and leave the
  /// rest.
  virtual void on_readable(canopen::TimePoint now) noexcept = 0;
  /// When on_time() is wanted; read anew in every turn of the loop.
  [[nodiscard]] virtual canopen::TimePoint next_deadline() const noexcept { return canopen::kNever; }
  virtual void on_time(canopen::TimePoint) noexcept {}
  /// Fills in its row of the statistics; false if it has none.
  [[nodiscard]] virtual bool statistics(userbus::MemberStatistics&) const noexcept { return false; }
};

/// The loop as a source sees it: where it may put more sources, or take itself out.
class SourceList {
 public:
  SourceList() = default;
  SourceList(const SourceList&) = delete;
  SourceList& operator=(const SourceList&) = delete;
  virtual ~SourceList() = default;

  /// Watches @p source until remove(); std::system_error if its descriptor cannot be watched.
  virtual void add(Source& source) = 0;
  /// No function of @p source is called any more when this returns, except the one that is running.
  virtual void remove(Source& source) noexcept = 0;
};

}  // namespace hub
