#include "tools/axisctl/scenario/language/keys.hpp"

#include <array>

namespace scenario {
namespace {

constexpr double kMostMilliseconds = kLongestScenario * 1000.0;
constexpr double kLargestSeed = 9007199254740991.0;  // JSON numbers that every reader holds exactly

constexpr std::array kScenario{
    Key{.key = "$schema", .form = Form::Text, .help = "for editors", .absent = kNothing},
    Key{.key = "title", .form = Form::Text, .help = "what it shows, in one line"},
    Key{.key = "about",
        .form = Form::Texts,
        .help = "where the problem comes from, and what is shown",
        .absent = kNothing},
    Key{.key = "references", .form = Form::Texts, .help = "who has had it: threads, clauses", .absent = kNothing},
    Key{.key = "seed",
        .form = Form::Integer,
        .help = "of the draws of all faults that have no seed of their own",
        .high = kLargestSeed,
        .absent = "1"},
    Key{.key = "limit_s",
        .form = Form::Number,
        .help = "longest time of the whole scenario (s)",
        .low = 0.1,
        .high = kLongestScenario,
        .absent = "60"},
    Key{.key = "bus", .form = Form::Bus, .help = "the bus", .absent = "frames take no time"},
    Key{.key = "units", .form = Form::Units, .help = "drive units, each an axisd of its own", .absent = kNothing},
    Key{.key = "programs",
        .form = Form::Programs,
        .help = "programs under test, on the same bus",
        .absent = kNothing},
    Key{.key = "steps", .form = Form::Steps, .help = "what happens, one after the other"},
};

constexpr std::array kBus{
    Key{.key = "bit_rate",
        .form = Form::Integer,
        .help = "bit/s; 0: frames take no time",
        .high = 1'000'000,
        .absent = "0"},
    Key{.key = "inject", .form = Form::Faults, .help = "faults of the bus from the start on", .absent = kNothing},
};

constexpr double kHighestNode = 127;
constexpr std::array kUnit{
    Key{.key = "name", .form = Form::Word, .help = "what steps call it"},
    Key{.key = "node_id", .form = Form::Integer, .help = "node-ID", .low = 1, .high = kHighestNode},
    Key{.key = "config",
        .form = Form::Object,
        .help = "configuration of the unit: axes, motors, loads, parameters",
        .absent = "one servo axis"},
    Key{.key = "inject", .form = Form::Faults, .help = "faults of the unit from the start on", .absent = kNothing},
    Key{.key = "on", .form = Form::Boolean, .help = "whether it is on when the steps begin", .absent = "true"},
};

constexpr double kHighestStatus = 255;
constexpr std::array kProgram{
    Key{.key = "name", .form = Form::Word, .help = "what steps call it"},
    Key{.key = "command", .form = Form::Texts, .help = "program and arguments"},
    Key{.key = "exit_status",
        .form = Form::Integer,
        .help = "what it has to end with, before the scenario is over",
        .high = kHighestStatus,
        .absent = "it may still run, or end as it likes"},
    Key{.key = "by_step", .form = Form::Boolean, .help = "true: a step `start` starts it", .absent = "false"},
};

constexpr std::array kStep{
    Key{.key = "name",
        .form = Form::Word,
        .help = "for `until` of other steps, and for the report",
        .absent = kNothing},
    Key{.key = "about", .form = Form::Text, .help = "what it is for, shown in the report", .absent = kNothing},
    Key{.key = "at_ms",
        .form = Form::Number,
        .help = "begins at this time since the first step could begin, or when the step before is over",
        .high = kMostMilliseconds,
        .absent = "at once"},
    Key{.key = "after_ms",
        .form = Form::Number,
        .help = "begins so long after the step before",
        .high = kMostMilliseconds,
        .absent = "at once"},
    Key{.key = "on", .form = Form::Condition, .help = "begins when this holds, within 5 s", .absent = "at once"},
};

// What stands beside an action or a condition.
constexpr Key kOfUnit{
    .key = "unit", .form = Form::Word, .help = "the unit that is meant", .absent = "the only one"};
constexpr Key kAxis{.key = "axis", .form = Form::Integer, .help = "the axis", .low = 1, .high = 8, .absent = "1"};
constexpr Key kWithin{
    .key = "within_ms", .form = Form::Number, .help = "longest wait", .high = kMostMilliseconds, .absent = "5000"};
constexpr Key kIs{.key = "is", .form = Form::Scalar, .help = "what it is", .absent = kNothing};
constexpr double kAny = 1e300;
constexpr Key kAtLeast{.key = "at_least",
                       .form = Form::Number,
                       .help = "lower limit",
                       .low = -kAny,
                       .high = kAny,
                       .absent = kNothing};
constexpr Key kAtMost{
    .key = "at_most", .form = Form::Number, .help = "upper limit", .low = -kAny, .high = kAny, .absent = kNothing};
constexpr Key kServer{.key = "server",
                      .form = Form::Integer,
                      .help = "SDO server, 1 is that of 1200h",
                      .low = 1,
                      .high = 128,
                      .absent = "1"};
constexpr Key kAbort{
    .key = "abort", .form = Form::Text, .help = "the abort code that has to come, 0x06020000", .absent = kNothing};
constexpr std::array<std::string_view, 2> kNoAnswers{"none", "malformed"};
constexpr Key kAnswer{.key = "answer",
                      .form = Form::Choice,
                      .help = "`none`: nothing answers; `malformed`: the answer is not one of the protocol",
                      .absent = "what CiA 301 says",
                      .choices = kNoAnswers};
constexpr Key kFor{.key = "for_ms",
                   .form = Form::Number,
                   .help = "the step takes so long and looks all the time",
                   .high = kMostMilliseconds,
                   .absent = "the steps go on, and it counts to the end"};
constexpr Key kUntil{.key = "until",
                     .form = Form::Word,
                     .help = "name of the step at whose beginning it counts no longer",
                     .absent = "the end"};
constexpr Key kAs{.key = "as", .form = Form::Word, .help = "a name, to take it back by", .absent = kNothing};

constexpr std::array<std::string_view, 5> kNmtCommands{"start", "stop", "pre-operational", "reset-node",
                                                       "reset-communication"};
constexpr std::array<std::string_view, 2> kOnOff{"on", "off"};
constexpr std::array<std::string_view, 4> kSignals{"KILL", "TERM", "STOP", "CONT"};
constexpr std::array kSendKeys{
    Key{.key = "times", .form = Form::Integer, .help = "how often", .low = 1, .high = 100'000, .absent = "1"}};
constexpr std::array kCyclicKeys{
    Key{.key = "every_ms", .form = Form::Number, .help = "period", .low = 0.5, .high = kMostMilliseconds},
    Key{.key = "as", .form = Form::Word, .help = "a name, to stop it by"}};
constexpr std::array kNmtKeys{kOfUnit};
constexpr std::array kReadKeys{kOfUnit, kServer, kIs, kAtLeast, kAtMost, kAbort, kAnswer, kWithin};
constexpr std::array kWriteKeys{
    kOfUnit,
    Key{.key = "value", .form = Form::Scalar, .help = "a whole number, or 0x... as a text"},
    Key{.key = "bytes",
        .form = Form::Integer,
        .help = "how many bytes it has",
        .low = 1,
        .high = 8,
        .absent = "4"},
    kServer,
    kAbort,
    kAnswer,
    kWithin};
constexpr std::array kSetKeys{kOfUnit, Key{.key = "value", .form = Form::Scalar, .help = "what it is set to"}};
constexpr std::array kTurnOnKeys{kOfUnit, kWithin};
constexpr std::array kInjectKeys{kOfUnit, kAs};
constexpr std::array kPowerKeys{kOfUnit};
constexpr std::array kCallKeys{
    kOfUnit, Key{.key = "params", .form = Form::Object, .help = "its parameters", .absent = "none"},
    Key{.key = "result", .form = Form::Object, .help = "members that the result has to have", .absent = kNothing},
    Key{.key = "refused", .form = Form::Boolean, .help = "true: it has to be refused", .absent = "false"}};
constexpr std::array kExpectKeys{kWithin};
constexpr std::array kNeverKeys{kFor, kUntil};
constexpr std::array kKillKeys{
    Key{.key = "signal", .form = Form::Choice, .help = "how", .absent = "KILL", .choices = kSignals}};

constexpr std::array kActions{
    Alternative{{.key = "send", .form = Form::Frame, .help = "sends a frame"}, kSendKeys},
    Alternative{{.key = "cyclic", .form = Form::Frame, .help = "sends a frame again and again from now on"},
                kCyclicKeys},
    Alternative{{.key = "stop", .form = Form::Word, .help = "ends a cyclic frame"}},
    Alternative{
        {.key = "nmt", .form = Form::Choice, .help = "sends an NMT command to a unit", .choices = kNmtCommands},
        kNmtKeys},
    Alternative{{.key = "read", .form = Form::Entry, .help = "reads an entry over SDO"}, kReadKeys},
    Alternative{{.key = "write", .form = Form::Entry, .help = "writes an entry over SDO"}, kWriteKeys},
    Alternative{
        {.key = "set", .form = Form::Text, .help = "sets a parameter of a unit over its control socket: 1/p1120"},
        kSetKeys},
    Alternative{{.key = "turn_on",
                 .form = Form::Integer,
                 .help = "leads an axis to Operation enabled by the controlwords 6, 7, 15 in its first RPDO",
                 .low = 1,
                 .high = 8},
                kTurnOnKeys},
    Alternative{
        {.key = "inject", .form = Form::Fault, .help = "loads a fault into a unit; a bus fault into the bus"},
        kInjectKeys},
    Alternative{{.key = "remove", .form = Form::Word, .help = "takes a fault back, by its name `as`"}},
    Alternative{{.key = "power", .form = Form::Choice, .help = "switches a unit off or on", .choices = kOnOff},
                kPowerKeys},
    Alternative{{.key = "call", .form = Form::Text, .help = "asks for any method of the control socket"},
                kCallKeys},
    Alternative{{.key = "wait_ms", .form = Form::Number, .help = "lets time pass", .high = kMostMilliseconds}},
    Alternative{{.key = "expect", .form = Form::Condition, .help = "waits until it holds"}, kExpectKeys},
    Alternative{{.key = "never", .form = Form::Condition, .help = "must not hold"}, kNeverKeys},
    Alternative{{.key = "always", .form = Form::State, .help = "must go on to hold"}, kNeverKeys},
    Alternative{{.key = "start", .form = Form::Word, .help = "starts a program with `by_step`"}},
    Alternative{{.key = "kill", .form = Form::Word, .help = "sends a signal to a program"}, kKillKeys},
};

constexpr std::array<std::string_view, 4> kNmtStates{"initialising", "pre-operational", "operational", "stopped"};
constexpr std::array<std::string_view, 8> kDriveStates{
    "not-ready-to-switch-on", "switch-on-disabled", "ready-to-switch-on",    "switched-on",
    "operation-enabled",      "quick-stop-active",  "fault-reaction-active", "fault"};
constexpr std::array<std::string_view, 4> kBusStates{"error-active", "error-warning", "error-passive", "bus-off"};
constexpr std::array kFrameKeys{
    Key{.key = "mask", .form = Form::Bytes, .help = "bits of the data that count", .absent = "all"},
    Key{.key = "count",
        .form = Form::Integer,
        .help = "so many of them",
        .low = 1,
        .high = 100'000,
        .absent = "1"}};
constexpr std::array kNmtStateKeys{kOfUnit};
constexpr std::array kDriveStateKeys{kOfUnit, kAxis};
constexpr std::array kSignalKeys{kOfUnit, kIs, kAtLeast, kAtMost};
constexpr std::array kFaultKeys{kOfUnit, kAxis};
constexpr std::array kHitsKeys{kIs, kAtLeast, kAtMost};
constexpr std::array kProgramKeys{Key{.key = "exit_status",
                                      .form = Form::Integer,
                                      .help = "with this status",
                                      .high = kHighestStatus,
                                      .absent = "any"}};

constexpr std::array kConditions{
    Alternative{{.key = "frame", .form = Form::Pattern, .help = "a frame on the bus"}, kFrameKeys},
    Alternative{{.key = "nmt_state", .form = Form::Choice, .help = "NMT state of a unit", .choices = kNmtStates},
                kNmtStateKeys},
    Alternative{{.key = "drive_state",
                 .form = Form::Choice,
                 .help = "state of an axis (CiA 402)",
                 .choices = kDriveStates},
                kDriveStateKeys},
    Alternative{{.key = "signal",
                 .form = Form::Text,
                 .help = "a signal of `axisctl signal list`, or a parameter: 1/speed, 1/r0063"},
                kSignalKeys},
    Alternative{{.key = "fault",
                 .form = Form::Integer,
                 .help = "a fault of an axis, by its number",
                 .low = 1,
                 .high = 65535},
                kFaultKeys},
    Alternative{{.key = "no_fault", .form = Form::Boolean, .help = "an axis has no fault"}, kFaultKeys},
    Alternative{{.key = "bus_state",
                 .form = Form::Choice,
                 .help = "error state of the controller of a unit",
                 .choices = kBusStates},
                kNmtStateKeys},
    Alternative{{.key = "hits", .form = Form::Word, .help = "how often a fault has hit, by its name `as`"},
                kHitsKeys},
    Alternative{{.key = "ended", .form = Form::Word, .help = "a program has ended"}, kProgramKeys},
};

}  // namespace

std::span<const Key> scenario_keys() noexcept {
  return kScenario;
}
std::span<const Key> bus_keys() noexcept {
  return kBus;
}
std::span<const Key> unit_keys() noexcept {
  return kUnit;
}
std::span<const Key> program_keys() noexcept {
  return kProgram;
}
std::span<const Key> step_keys() noexcept {
  return kStep;
}
std::span<const Alternative> actions() noexcept {
  return kActions;
}
std::span<const Alternative> conditions() noexcept {
  return kConditions;
}

}  // namespace scenario
