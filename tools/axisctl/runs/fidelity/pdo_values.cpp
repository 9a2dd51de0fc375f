#include "tools/axisctl/runs/fidelity/pdo_values.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include <fmt/format.h>

#include "meaning/words.hpp"

namespace runs {
namespace {

/// What a course has of an object about a time.
struct Spread {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  bool has_same = false;

  [[nodiscard]] bool empty() const noexcept { return low > high; }
  /// By how much @p value is outside.
  [[nodiscard]] double distance(double value) const noexcept { return std::max({low - value, value - high, 0.0}); }
};

/// The frames that hold at some time within @p band around @p at: those that come in it, and the last one before.
std::span<const PdoImage> about(const std::vector<PdoImage>& images, canopen::Duration at,
                                canopen::Duration band) {
  auto first = std::ranges::lower_bound(images, at - band, {}, &PdoImage::at);
  const auto last = std::ranges::upper_bound(images, at + band, {}, &PdoImage::at);
  if (first != images.begin()) --first;
  return {first, last};
}

Spread spread_of(std::span<const PdoImage> images, const PdoImage::Measured& wanted) {
  Spread spread;
  for (const PdoImage& image : images)
    for (const PdoImage::Measured& there : image.measured) {
      if (there.object.index != wanted.object.index || there.object.sub_index != wanted.object.sub_index) continue;
      spread.low = std::min(spread.low, there.value);
      spread.high = std::max(spread.high, there.value);
      spread.has_same = spread.has_same || there.value == wanted.value;
    }
  return spread;
}

std::string text_of(const Spread& spread) {
  return spread.low == spread.high ? fmt::format("{}", spread.low)
                                   : fmt::format("{} to {}", spread.low, spread.high);
}

class ValueJudge {
 public:
  ValueJudge(const PdoPair& pdo, const Yardstick& yardstick, const Extents& extents, Verdict& verdict)
      : pdo_{pdo}, yardstick_{yardstick}, extents_{extents}, verdict_{verdict} {}

  /// False if there is a difference.
  bool judge_log(const TimeMap& times) {
    bool is_good = true;
    for (const PdoImage& image : pdo_.log) {
      const auto there = about(pdo_.run, times.there(image.at), times.band(image.at));
      for (const PdoImage::Measured& wanted : image.measured)
        is_good = judge(image, wanted, spread_of(there, wanted)) && is_good;
    }
    return is_good;
  }

  void judge_run(const TimeMap& back) {
    for (const PdoImage& image : pdo_.run) {
      const canopen::Duration at = back.there(image.at);
      if (pdo_.log.empty() || at > pdo_.log.back().at) break;
      const auto there = about(pdo_.log, at, back.band(image.at));
      for (const PdoImage::Measured& found : image.measured) {
        const Spread spread = spread_of(there, found);
        if (spread.empty() || is_within(found, spread)) continue;
        Finding finding = finding_of(found, at);
        finding.log = text_of(spread);
        finding.run = fmt::format("{}", found.value);
        verdict_.add(std::move(finding));
      }
    }
  }

 private:
  [[nodiscard]] bool is_within(const PdoImage::Measured& value, const Spread& spread) const {
    const Band band = yardstick_.bands.of(value.object).value_or(Band{});
    return !spread.empty() && spread.distance(value.value) <= extents_.tolerance(value.object, band);
  }

  bool judge(const PdoImage& image, const PdoImage::Measured& wanted, const Spread& spread) {
    if (spread.has_same) {
      verdict_.add_same(Aspect::PdoValue);
      return true;
    }
    if (is_within(wanted, spread)) {
      verdict_.add_within(Aspect::PdoValue);
      return true;
    }
    Finding finding = finding_of(wanted, image.at);
    if (spread.empty()) finding.nature = Nature::Missing;
    finding.place = image.place;
    finding.log = fmt::format("{}", wanted.value);
    finding.run = spread.empty() ? "nothing" : text_of(spread);
    verdict_.add(std::move(finding));
    return false;
  }

  [[nodiscard]] Finding finding_of(const PdoImage::Measured& value, canopen::Duration at) const {
    return {.aspect = Aspect::PdoValue,
            .nature = Nature::Value,
            .object = value.object,
            .at = at,
            .what = fmt::format("{}, {}", pdo_.what, meaning::name_of(value.object, yardstick_.description))};
  }

  const PdoPair& pdo_;
  const Yardstick& yardstick_;
  const Extents& extents_;
  Verdict& verdict_;
};

}  // namespace

void judge_values(const PdoPair& pdo, const TimeMap& back, const Assessment& assessment) {
  ValueJudge judge{pdo, assessment.yardstick, assessment.extents, assessment.verdict};
  if (judge.judge_log(assessment.times)) judge.judge_run(back);
}

}  // namespace runs
