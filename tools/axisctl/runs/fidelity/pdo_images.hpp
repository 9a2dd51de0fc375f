#pragma once

#include <array>
#include <map>
#include <vector>

#include "tools/axisctl/runs/fidelity/verdict.hpp"
#include "tools/axisctl/runs/replay/course.hpp"

namespace runs {

/// A TPDO, taken apart by its mapping.
struct PdoImage {
  struct Measured {
    canopen::sdo::Address object{};
    double value = 0;
  };
  canopen::Duration at{};
  std::uint64_t place = 0;
  std::vector<std::uint8_t> words{};              ///< all of it, with 0 in place of measured values
  std::optional<canopen::sdo::Address> object{};  ///< what the words are of, if it is one object
  std::vector<Measured> measured{};
  canopen::Frame frame{};
};

/// The TPDOs of a course by their numbers.
using PdoImages = std::map<meaning::Meaning, std::vector<PdoImage>>;

/// Takes the TPDOs of @p course apart: by the mapping of the EDS, and by what was written and read since. Without
/// a mapping a TPDO is words alone.
[[nodiscard]] PdoImages images_of(const Course& course, const Yardstick& yardstick);

}  // namespace runs
