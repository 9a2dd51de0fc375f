#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "drive/drive_unit.hpp"

namespace axisd {

/// The values of drive objects one after the other, each with its place, in the order of the drive objects,
/// numbers and indices: what lists are paged by.
class ParameterSequence {
 public:
  /// One value.
  struct Item {
    const drive::DriveObject& object;
    const drive::PlacedRow& placed;
    std::size_t index;
  };

  /// Of @p object, or of all drive objects of @p unit if that is nullptr.
  ParameterSequence(const drive::DriveUnit& unit, const drive::DriveObject* object) {
    unit.for_each_object([&](const drive::DriveObject& each) {
      if (object == nullptr || object == &each) objects_.push_back(&each);
    });
  }

  /// Calls @p visit with every item from place @p from on and its place, until it says false.
  template <class Visit>
  void visit(std::size_t from, const Visit& visit) const {
    std::size_t place = 0;
    for (const drive::DriveObject* const object : objects_)
      for (const drive::PlacedRow& placed : drive::parameters_of(object->kind())) {
        if (!object->provides(*placed.row)) continue;
        const std::size_t begin = place;
        place += placed.row->count;
        for (std::size_t at = std::max(begin, from); at < place; ++at)
          if (!visit(Item{*object, placed, at - begin}, at)) return;
      }
  }
  /// How many there are.
  std::size_t size() const {
    std::size_t count = 0;
    for (const drive::DriveObject* const object : objects_)
      for (const drive::PlacedRow& placed : drive::parameters_of(object->kind()))
        if (object->provides(*placed.row)) count += placed.row->count;
    return count;
  }

 private:
  std::vector<const drive::DriveObject*> objects_;
};

}  // namespace axisd
