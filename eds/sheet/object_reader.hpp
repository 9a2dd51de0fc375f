#pragma once

#include <cstddef>
#include <map>

#include "eds/document/finding.hpp"
#include "eds/sheet/data_sheet.hpp"
#include "eds/sheet/field_reader.hpp"

namespace eds {

/// The sections of one object.
struct ObjectSections {
  const Section* object = nullptr;
  std::map<std::uint8_t, const Section*> subs;
  const Section* names = nullptr;
  const Section* values = nullptr;
  const Section* denotations = nullptr;
};

/// Reads the objects of a file.
class ObjectReader {
 public:
  /// Values that the node-ID is added to must fit on every one of @p nodes.
  ObjectReader(Findings& findings, NodeRange nodes) : findings_{findings}, nodes_{nodes} {}

  /// The object @p name of @p sections.
  [[nodiscard]] SheetObject object(const SectionName& name, const ObjectSections& sections);
  /// What MxSubExtxxxx says.
  [[nodiscard]] SubExtension extension(const SectionName& name, const Section& section);

 private:
  [[nodiscard]] SheetEntry entry(std::uint8_t sub_index, const Section& section);
  [[nodiscard]] Stated<canopen::Access> access(const Section& section);
  void expand(SheetObject& object, const ObjectSections& sections);
  void fill(SheetObject& object, const ObjectSections& sections);

  /// CompactSubObj: how many sub-indices follow sub-index 0.
  [[nodiscard]] Stated<std::uint64_t> compact_count(const FieldReader& fields);

  Findings& findings_;
  NodeRange nodes_;
  std::size_t expanded_ = 0;  ///< entries made from CompactSubObj
};

}  // namespace eds
