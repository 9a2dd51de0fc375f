#include "tools/axisctl/runs/fidelity/pdo_images.hpp"

#include <algorithm>
#include <span>

#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/base/object_index.hpp"
#include "tools/axisctl/runs/fidelity/measured_value.hpp"

namespace runs {
namespace {

namespace object = canopen::object;

constexpr unsigned kMostMapped = 8, kBits = 8;

/// What an entry of a PDO mapping says (CiA 301, 7.5.2.36).
struct Mapped {
  canopen::sdo::Address at;
  unsigned bits;
};
Mapped mapped(std::uint32_t entry) noexcept {
  return {{static_cast<std::uint16_t>(entry >> 16U), static_cast<std::uint8_t>(entry >> 8U)}, entry & 0xFFU};
}

/// The mappings of TPDOs as they are told.
class Mappings {
 public:
  explicit Mappings(const eds::Description& description) {
    for (const eds::EntryFacts& entry : description.entries()) {
      const auto value = entry.initial ? entry.initial->at(description.node_id()) : std::nullopt;
      if (value && !value->negative)
        learn({.node = description.node_id(),
               .at = {entry.index, entry.sub_index},
               .value = static_cast<std::uint32_t>(value->magnitude)});
    }
  }

  void learn(const meaning::EntryValue& entry) {
    if (entry.at.index < object::kTpdoMapping || entry.at.index >= object::kPdosEnd ||
        entry.at.sub_index > kMostMapped)
      return;
    const auto number = static_cast<std::uint16_t>(entry.at.index - object::kTpdoMapping + 1);
    mappings_[{meaning::Role::Tpdo, entry.node, number}][entry.at.sub_index] = entry.value;
  }

  /// What @p frame, TPDO @p pdo, is made of; nothing if that is not known, or does not fit.
  [[nodiscard]] std::vector<Mapped> of(const meaning::Meaning& pdo, const canopen::Frame& frame) const {
    const auto known = mappings_.find(pdo);
    if (known == mappings_.end()) return {};
    std::vector<Mapped> fields;
    unsigned bits = 0;
    for (unsigned i = 1; i <= std::min<std::uint32_t>(known->second[0], kMostMapped); ++i) {
      fields.push_back(mapped(known->second[i]));
      bits += fields.back().bits;
    }
    if (bits != frame.length * kBits) return {};
    return fields;
  }

 private:
  std::map<meaning::Meaning, std::array<std::uint32_t, kMostMapped + 1>> mappings_;
};

PdoImage image_of(const Passage& passage, const std::vector<Mapped>& fields, const Yardstick& yardstick) {
  PdoImage image{.at = passage.at, .place = passage.place, .frame = passage.frame};
  const auto data = std::span{passage.frame.data}.first(std::min<std::size_t>(passage.frame.length, 8));
  image.words.assign(data.begin(), data.end());
  unsigned at = 0, words = 0;
  for (const Mapped& field : fields) {
    const bool is_of_bytes = at % kBits == 0 && field.bits % kBits == 0 && field.bits != 0;
    if (is_of_bytes && yardstick.bands.of(field.at)) {
      const auto bytes = data.subspan(at / kBits, field.bits / kBits);
      image.measured.push_back({field.at, measured_value(field.at, bytes, yardstick.description)});
      std::fill_n(image.words.begin() + at / kBits, field.bits / kBits, std::uint8_t{0});
    } else if (++words == 1) {
      image.object = field.at;
    }
    at += field.bits;
  }
  if (words > 1) image.object.reset();
  return image;
}

}  // namespace

PdoImages images_of(const Course& course, const Yardstick& yardstick) {
  PdoImages images;
  Mappings mappings{yardstick.description};
  for (const Passage& passage : course.passages) {
    if (passage.entry) mappings.learn(*passage.entry);
    if (passage.meaning.role != meaning::Role::Tpdo || passage.is_of_master) continue;
    images[passage.meaning].push_back(image_of(passage, mappings.of(passage.meaning, passage.frame), yardstick));
  }
  return images;
}

}  // namespace runs
