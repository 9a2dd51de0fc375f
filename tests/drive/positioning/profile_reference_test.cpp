#include <algorithm>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "tests/drive/positioning/recorded_motion.hpp"

namespace drive {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// Positioning by MDI with steps of the velocity override, with jerk limiting where the file has it.
void follow_override(std::string_view name) {
  RecordedMotion run{name};
  const nlohmann::json& stimulus = run.file.about.at("stimulus");
  run.motion.place(stimulus.at("start").get<double>());
  if (run.parameter("p2575") > 0.0)
    run.motion.set_jerk_time(std::max(run.acceleration("p2572"), run.acceleration("p2573")) /
                             run.acceleration("p2574"));
  for (const nlohmann::json& step : stimulus.at("override"))
    run.at(step.at("t_s").get<double>(), [&run, &stimulus, share = step.at("pct").get<double>() / 100.0] {
      const double velocity = std::min(run.velocity("p2643") * share, run.velocity("p2571"));
      run.motion.move_to(stimulus.at("target").get<double>(),
                         {velocity, run.acceleration("p2572"), run.acceleration("p2573")});
    });
  run.run();
  run.expect_agreement();
}

TEST(ProfileReference, FollowsTheOverride) {
  follow_override("k1_override");
}

TEST(ProfileReference, LimitsTheJerkOfALongWay) {
  follow_override("k2_jerk_long");
}

TEST(ProfileReference, LimitsTheJerkOfARampShorterThanItsTime) {
  follow_override("k3_jerk_short_accel");
}

TEST(ProfileReference, LimitsTheJerkFromAccelerationIntoDeceleration) {
  follow_override("k4_jerk_direct");
}

/// MDI setpoints taken in motion.
void follow_setpoints(std::string_view name) {
  RecordedMotion run{name};
  run.motion.place(0.0);
  for (const nlohmann::json& setpoint : run.file.about.at("stimulus"))
    run.at(setpoint.at("t_s").get<double>(), [&run, &setpoint] {
      run.motion.move_to(setpoint.at("p2642").get<double>(),
                         {setpoint.at("p2643").get<double>() * kVelocityUnit, run.acceleration("p2572"),
                          run.acceleration("p2573") * setpoint.value("p2645", 100.0) / 100.0},
                         true);
    });
  run.run();
  run.expect_agreement();
}

TEST(ProfileReference, TakesNewTargetsInMotion) {
  follow_setpoints("k5_mdi_retarget");
}

TEST(ProfileReference, ReversesToATargetBehind) {
  follow_setpoints("k6_mdi_reverse");
}

/// Way (LU) from @p from to @p target on a modulo axis.
double modulo_way(double from, double target, double range, const std::string& way) {
  const double forward = target - from + (target < from ? range : 0.0);
  if (way == "positive") return forward;
  if (way == "negative") return forward - range;
  return forward <= range / 2.0 ? forward : forward - range;
}

TEST(ProfileReference, GoesEveryWayOfAModuloAxis) {
  RecordedMotion run{"k7_modulo"};
  const double range = run.parameter("p2576");
  const nlohmann::json& stimulus = run.file.about.at("stimulus");
  run.motion.place(stimulus.at("start").get<double>());
  for (const nlohmann::json& task : stimulus.at("tasks"))
    run.at(task.at("t_s").get<double>(), [&run, &task, range] {
      const double from = run.motion.position();
      run.motion.move_to(from + modulo_way(from, task.at("p2642").get<double>(), range, task.at("way")),
                         {run.velocity("p2643"), run.acceleration("p2572"), run.acceleration("p2573")});
    });
  run.run([&run, range] {
    run.motion.advance(kMotionCycle);
    const double turns = std::floor(run.motion.position() / range);
    if (turns == 0.0) return;
    run.motion.shift(-turns * range);
    run.turned += turns * range;
  });
  run.expect_agreement();
}

TEST(ProfileReference, StopsOnTheWayAndGoesOn) {
  RecordedMotion run{"k8_stop_reject"};
  const auto stimulus = [&run](const char* name) { return run.file.number(std::string{"/stimulus/"} + name); };
  const double a = run.acceleration("p2572") * run.parameter("p2619") / 100.0;
  const double d = run.acceleration("p2573") * run.parameter("p2620") / 100.0;
  const auto start = [&] { run.motion.move_to(stimulus("target"), {run.velocity("p2618"), a, d}); };
  run.motion.place(stimulus("start_pos"));
  run.at(stimulus("start"), start);
  run.at(stimulus("p2640_0"), [&run, d] { run.motion.brake(d); });
  run.at(stimulus("p2640_1"), start);
  run.at(stimulus("p2641_0"), [&run] { run.motion.brake(run.acceleration("p2573")); });
  run.at(stimulus("restart"), start);
  run.run();
  run.expect_agreement();
}

TEST(ProfileReference, FliesFromBlockToBlock) {
  RecordedMotion run{"k9_flying"};
  const nlohmann::json& blocks = run.file.about.at("stimulus").at("blocks");
  std::size_t at = 0;
  const auto target = [&](std::size_t i) { return blocks[i].at("p2617").get<double>(); };
  const auto start = [&] {
    const auto number = [&](const char* name) { return blocks[at].at(name).get<double>(); };
    run.motion.move_to(target(at),
                       {number("p2618") * kVelocityUnit, run.acceleration("p2572") * number("p2619") / 100.0,
                        run.acceleration("p2573") * number("p2620") / 100.0});
  };
  run.motion.place(0.0);
  run.at(0.0, start);
  run.run([&] {
    for (double left = kMotionCycle; left > 0.0;) {
      const bool last = at + 1 == blocks.size();
      const bool flies = !last && (target(at + 1) - target(at)) * run.motion.velocity() > 0.0;
      const auto advance = run.motion.advance(left, flies, !last);
      left = advance.left;
      if (advance.event == TrapezoidProfile::Event::None) continue;
      ++at;
      start();
    }
  });
  EXPECT_EQ(at + 1, blocks.size());
  run.expect_agreement();
}

TEST(ProfileReference, JogsAndStandsExactlyOnTheLimit) {
  RecordedMotion run{"k12_jog_limit"};
  const auto when = [&run](const char* name) { return run.file.number(std::string{"/stimulus/"} + name); };
  const auto jog = [&run](const char* speed) {
    return [&run, velocity = run.velocity(speed)] {
      const double limit = velocity > 0.0 ? run.parameter("p2581") : -kEndless;
      run.motion.move_to(limit, {std::abs(velocity), run.acceleration("p2572"), run.acceleration("p2573")});
    };
  };
  const auto release = [&run] { run.motion.brake(run.acceleration("p2573")); };
  run.motion.place(when("start_pos"));
  run.at(when("jog2_on"), jog("p2586"));
  run.at(when("jog2_off"), release);
  run.at(when("jog1_on"), jog("p2585"));
  run.at(when("jog1_off"), release);
  run.at(when("jog2_on_again"), jog("p2586"));
  run.run();
  run.expect_agreement();
}

/// Until the motion passes @p place (s), at most @p left.
double time_until(const TrapezoidProfile& motion, double place, double left) {
  const bool below = motion.position() < place;
  const auto passes = [&](double time) {
    TrapezoidProfile ahead = motion;
    ahead.advance(time);
    return (ahead.position() < place) != below;
  };
  if (!passes(left)) return left;
  double least = 0.0;
  double most = left;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (least + most);
    (passes(middle) ? most : least) = middle;
  }
  return most;
}

TEST(ProfileReference, ApproachesTheReferencePoint) {
  RecordedMotion run{"k13_reference_approach"};
  const double edge = run.file.number("/stimulus/cam_edge");
  const double mark = run.file.number("/stimulus/zero_mark_at");
  const auto limits = [&run](const char* speed) {
    return MotionLimits{run.velocity(speed), run.acceleration("p2572"), run.acceleration("p2573")};
  };
  enum class Step : std::uint8_t { Cam, Turn, Mark, Point } step = Step::Cam;
  run.motion.place(0.0);
  run.at(0.0, [&] { run.motion.move_to(kEndless, limits("p2605")); });
  run.run([&] {
    const bool seeks = step == Step::Cam || step == Step::Mark;
    const double place = step == Step::Cam ? edge : mark;
    const double time = seeks ? time_until(run.motion.unlimited(), place, kMotionCycle) : kMotionCycle;
    const auto advance = run.motion.advance(time, false, step == Step::Turn);
    const double left = kMotionCycle - time + advance.left;
    if (step == Step::Cam && time < kMotionCycle) {
      run.motion.brake(run.acceleration("p2573"));
      step = Step::Turn;
    } else if (advance.event == TrapezoidProfile::Event::Standstill) {
      run.motion.move_to(-kEndless, limits("p2608"));
      step = Step::Mark;
    } else if (step == Step::Mark && time < kMotionCycle) {
      run.motion.move_to(mark + run.parameter("p2600"), limits("p2611"));
      step = Step::Point;
    }
    run.motion.advance(left);
  });
  EXPECT_EQ(step, Step::Point);
  run.expect_agreement();
}

}  // namespace
}  // namespace drive
