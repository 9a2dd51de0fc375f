#pragma once

#include "record/event.hpp"

namespace axisd {

/// Something that has happened in a unit.
using UnitEvent = record::Event;

/// Who is told what happens in a unit, on the unit's thread. Nothing that is added or removed meanwhile may be a
/// listener of the same unit.
class EventListener {
 public:
  virtual ~EventListener() = default;
  virtual void on_event(const UnitEvent& event) noexcept = 0;
};

}  // namespace axisd
