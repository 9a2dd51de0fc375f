#pragma once

namespace drive {

/// What has to be done now and then, however long the steps of a cycle take. It changes nothing of the unit.
class Interlude {
 public:
  virtual ~Interlude() = default;
  /// Between two steps of a cycle.
  virtual void between_steps() noexcept = 0;
};

}  // namespace drive
