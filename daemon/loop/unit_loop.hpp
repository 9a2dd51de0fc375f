#pragma once

#include <list>
#include <thread>

#include "daemon/instance/instance.hpp"
#include "daemon/loop/event_loop.hpp"
#include "drive/joint_steps.hpp"
#include "service/log.hpp"
#include "service/mailbox.hpp"

namespace axisd {

/// The steps of drive units, made in common lanes.
class JointUnits final : public JointWork {
 public:
  bool add(drive::DriveUnit& unit) noexcept override { return steps_.add(unit); }
  void make() noexcept override { steps_.make(); }

 private:
  drive::JointSteps steps_;
};

/// A thread with the units that it runs. Whoever else wants something of a unit posts a job, which the thread does
/// between two turns; a turn does one job at most, so that no number of them keeps a drive from its cycles.
class UnitLoop final : private Service {
 public:
  /// Tells what @p log left out; lives by @p time, nullptr: the machine's. Both outlive this. Throws
  /// std::system_error.
  explicit UnitLoop(const Log& log, bus::TimeShare* time = nullptr);
  ~UnitLoop() override { stop(); }
  UnitLoop(const UnitLoop&) = delete;
  UnitLoop& operator=(const UnitLoop&) = delete;

  /// Before start(), or in a job: runs @p instance, which outlives this or is removed. Throws std::system_error.
  void add(Instance& instance);
  /// In a job, or after stop(): @p instance is run no longer.
  void remove(Instance& instance) noexcept;
  /// Begins the thread, whose first deed is the power-on of the units. Throws std::system_error.
  void start();
  /// Ends the thread after its present turn; jobs that wait are not done any more.
  void stop() noexcept;
  /// Any thread: @p job is done on the thread of this; where it is about @p instance, that is looked after behind
  /// it.
  void post(Mailbox::Job job, Instance* instance = nullptr);

 private:
  bool on_rare_event() noexcept override;
  void on_chores(canopen::TimePoint now) noexcept override { log_.tell_left_out(now); }
  canopen::TimePoint next_chores() const noexcept override { return log_.due(); }
  void look_after(Instance& instance) noexcept;
  void run() noexcept;

  const Log& log_;
  Mailbox mailbox_;
  os::Pollable rare_;
  std::list<Instance::RareSource> watched_;
  std::list<Instance*> instances_;
  JointUnits joint_;
  EventLoop loop_;
  bool stopping_ = false;
  os::Descriptor ended_;  ///< eventfd: the thread has nothing more to do
  std::thread thread_;
};

}  // namespace axisd
