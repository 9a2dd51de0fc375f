#pragma once

#include <functional>
#include <optional>

#include "tools/canopen-zoo/slave/slave.hpp"

namespace zoo {

/// An expedited download.
struct Write {
  std::uint16_t index = 0;
  std::uint8_t sub_index = 0;
  std::uint32_t value = 0;
};

/// The expedited download to @p slave in @p frame, if it is one.
[[nodiscard]] std::optional<Write> write_in(const Slave& slave, const canopen::Frame& frame);
/// Puts another value into the download in @p frame.
void rewrite(canopen::Frame& frame, std::uint32_t value);
/// Answers as if a download had been done.
void confirm(Slave& slave, const Write& write);
/// Answers a download with an abort.
void refuse(Slave& slave, const Write& write, std::uint32_t code);

using Judgement = std::function<bool(Slave&, const Write&)>;
/// A slave that confirms downloads that fulfil @p which, and forgets them.
[[nodiscard]] Defect pretends_to_write(Judgement which);
/// A slave that refuses downloads that fulfil @p which with @p code.
[[nodiscard]] Defect refuses_to_write(Judgement which, std::uint32_t code);
/// A slave that replaces values by @p value; nothing leaves them.
[[nodiscard]] Defect writes_otherwise(std::function<std::optional<std::uint32_t>(Slave&, const Write&)> value);
/// A slave that confirms one download of @p value to an entry and forgets it.
[[nodiscard]] Defect forgets(std::uint16_t index, std::uint8_t sub_index, std::uint32_t value);

/// What the slave holds in an entry.
[[nodiscard]] std::uint32_t held(Slave& slave, std::uint16_t index, std::uint8_t sub_index);
[[nodiscard]] bool operational(Slave& slave);

}  // namespace zoo
