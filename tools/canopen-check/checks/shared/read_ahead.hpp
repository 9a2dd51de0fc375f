#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <vector>

#include "tools/canopen-check/core/run/context.hpp"

namespace conformance {

/// Uploads of many entries in turn, for checks to which nearly every answer is right. They are asked for several
/// at a time where the server bears it; what is not clearly right is asked for once more, alone, so that a finding
/// rests on a transfer of its own.
class ReadAhead {
 public:
  ReadAhead(Context& context, std::vector<Multiplexor> entries)
      : context_{&context}, entries_{std::move(entries)} {}

  /// The frame that came ahead for the next entry; nothing where it has to be asked for alone.
  [[nodiscard]] std::optional<canopen::Frame> next_frame();
  /// The answer about the next entry: that which came ahead if @p is_right says so of it, else that of a step and
  /// a transfer of its own.
  template <std::predicate<const SdoAnswer&> IsRight>
  [[nodiscard]] SdoAnswer next(IsRight is_right) {
    const Multiplexor entry = entries_[at_];
    if (const auto frame = next_frame())
      if (const auto answer = whole_answer(*frame); answer && std::invoke(is_right, *answer)) return *answer;
    begin_step();
    return context_->read(entry.index, entry.sub_index);
  }
  /// Begins the step of a transfer of its own: no traffic of others is kept.
  void begin_step();

 private:
  void ask();

  Context* context_;
  std::vector<Multiplexor> entries_;
  std::vector<std::optional<canopen::Frame>> frames_;  ///< of the first entries
  std::size_t at_ = 0;                                 ///< the next one
};

/// True if the answer to an upload of @p entry is one frame, by the EDS: a number of at most four bytes, or an
/// abort because it is not there.
[[nodiscard]] bool fits_one_frame(const eds::Description& eds, const Multiplexor& entry) noexcept;

}  // namespace conformance
