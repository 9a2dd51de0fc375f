#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace scenario {

/// How the value of a key is written.
enum class Form : std::uint8_t {
  Text,       ///< not empty
  Texts,      ///< one text or several
  Word,       ///< a name: letters, digits, '-' and '_'
  Integer,    ///< from `low` to `high`
  Number,     ///< from `low` to `high`
  Boolean,    ///< true or false
  Choice,     ///< one of `choices`
  Frame,      ///< as candump prints it: "205#0F00", "705#R"
  Pattern,    ///< the same, x for any digit, * behind the data for any further bytes: "585#80406000*"
  Bytes,      ///< hexadecimal digits, two a byte
  Entry,      ///< an object of the dictionary: "6041", "1018:04"
  Scalar,     ///< a number, a text, true or false
  Object,     ///< any JSON object
  Fault,      ///< a fault on demand
  Faults,     ///< a list of them
  Condition,  ///< an object with a key of conditions()
  State,      ///< the same, but for frames
  Bus,        ///< an object with the keys bus_keys()
  Units,      ///< objects with the keys unit_keys()
  Programs,   ///< objects with the keys program_keys()
  Steps,      ///< objects with step_keys() and a key of actions()
};

/// A key of an object.
struct Key {
  std::string_view key;
  Form form = Form::Text;
  std::string_view help{};
  double low = 0.0;
  double high = 0.0;
  std::string_view absent{};                    ///< what holds without it; empty: it is required
  std::span<const std::string_view> choices{};  ///< of Form::Choice
};

/// A key that decides which others stand beside it.
struct Alternative {
  Key key;
  std::span<const Key> beside{};
};

[[nodiscard]] std::span<const Key> scenario_keys() noexcept;
[[nodiscard]] std::span<const Key> bus_keys() noexcept;
[[nodiscard]] std::span<const Key> unit_keys() noexcept;
[[nodiscard]] std::span<const Key> program_keys() noexcept;
/// Keys of every step, beside its action.
[[nodiscard]] std::span<const Key> step_keys() noexcept;
/// What a step does.
[[nodiscard]] std::span<const Alternative> actions() noexcept;
/// What can be waited for.
[[nodiscard]] std::span<const Alternative> conditions() noexcept;

/// Key::absent of a key that says nothing if it is not there.
inline constexpr std::string_view kNothing = "none";

/// Longest wait of a step (s), and of a whole scenario.
inline constexpr double kLongestScenario = 3600.0;
inline constexpr double kUsualScenario = 60.0;
/// Longest wait of a step that says none (ms).
inline constexpr double kUsualWait = 5000.0;

}  // namespace scenario
