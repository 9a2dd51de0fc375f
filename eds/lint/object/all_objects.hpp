#pragma once

#include <map>

#include "eds/sheet/data_sheet.hpp"

namespace eds {

/// The objects of the device and of all its modules together; of an index that stands in several modules the first
/// one.
class AllObjects {
 public:
  explicit AllObjects(const DataSheet& sheet) {
    for (const auto& [index, object] : sheet.objects) objects_.emplace(index, &object);
    for (const auto& [number, module] : sheet.modules)
      for (const auto& [index, object] : module.objects) objects_.emplace(index, &object);
    for (const auto& [number, module] : sheet.modules)
      for (const auto& [index, extension] : module.extensions) extensions_.emplace(index, &extension);
  }

  /// The object @p index, or null.
  [[nodiscard]] const SheetObject* object(std::uint16_t index) const {
    const auto found = objects_.find(index);
    return found == objects_.end() ? nullptr : found->second;
  }
  /// The entry, or null; any sub-index from 1 of what a module extends is there.
  [[nodiscard]] const SheetEntry* entry(std::uint16_t index, std::uint8_t sub_index) const {
    const SheetObject* const known = object(index);
    const SheetEntry* const found = known == nullptr ? nullptr : known->find(sub_index);
    if (found != nullptr || sub_index == 0) return found;
    const auto extension = extensions_.find(index);
    return extension == extensions_.end() ? nullptr : &extension->second->entry;
  }
  /// How many objects there are from @p first to @p last.
  [[nodiscard]] std::size_t count(std::uint16_t first, std::uint16_t last) const {
    return static_cast<std::size_t>(std::distance(objects_.lower_bound(first), objects_.upper_bound(last)));
  }
  [[nodiscard]] const std::map<std::uint16_t, const SheetObject*>& all() const noexcept { return objects_; }

 private:
  std::map<std::uint16_t, const SheetObject*> objects_;
  std::map<std::uint16_t, const SubExtension*> extensions_;
};

}  // namespace eds
