#include "can/preload/time/base/real.hpp"

#include <atomic>

#include "can/preload/look_up.hpp"

namespace preload {

namespace {

Real real_calls;
std::atomic<bool> real_known;

void look_up_real() noexcept {
  Real& calls = real_calls;
  const Entry entries[] = {
      {"clock_gettime", address_of(calls.clock_gettime)},
      {"gettimeofday", address_of(calls.gettimeofday)},
      {"time", address_of(calls.time)},
      {"timespec_get", address_of(calls.timespec_get)},
      {"nanosleep", address_of(calls.nanosleep)},
      {"clock_nanosleep", address_of(calls.clock_nanosleep)},
      {"usleep", address_of(calls.usleep)},
      {"sleep", address_of(calls.sleep)},
      {"sched_yield", address_of(calls.sched_yield)},
      {"poll", address_of(calls.poll)},
      {"ppoll", address_of(calls.ppoll)},
      {"select", address_of(calls.select)},
      {"pselect", address_of(calls.pselect)},
      {"epoll_wait", address_of(calls.epoll_wait)},
      {"epoll_pwait", address_of(calls.epoll_pwait)},
      {"epoll_pwait2", address_of(calls.epoll_pwait2)},
      {"accept", address_of(calls.accept)},
      {"accept4", address_of(calls.accept4)},
      {"timerfd_create", address_of(calls.timerfd_create)},
      {"timerfd_settime", address_of(calls.timerfd_settime)},
      {"timerfd_gettime", address_of(calls.timerfd_gettime)},
      {"setitimer", address_of(calls.setitimer)},
      {"getitimer", address_of(calls.getitimer)},
      {"alarm", address_of(calls.alarm)},
      {"timer_create", address_of(calls.timer_create)},
      {"timer_settime", address_of(calls.timer_settime)},
      {"timer_gettime", address_of(calls.timer_gettime)},
      {"timer_getoverrun", address_of(calls.timer_getoverrun)},
      {"timer_delete", address_of(calls.timer_delete)},
      {"sigtimedwait", address_of(calls.sigtimedwait)},
      {"sigwaitinfo", address_of(calls.sigwaitinfo)},
      {"sigwait", address_of(calls.sigwait)},
      {"sigsuspend", address_of(calls.sigsuspend)},
      {"pause", address_of(calls.pause)},
      {"kill", address_of(calls.kill)},
      {"sigqueue", address_of(calls.sigqueue)},
      {"pthread_create", address_of(calls.pthread_create)},
      {"pthread_join", address_of(calls.pthread_join)},
      {"pthread_timedjoin_np", address_of(calls.pthread_timedjoin_np)},
      {"pthread_clockjoin_np", address_of(calls.pthread_clockjoin_np)},
      {"pthread_mutex_lock", address_of(calls.pthread_mutex_lock)},
      {"pthread_mutex_timedlock", address_of(calls.pthread_mutex_timedlock)},
      {"pthread_mutex_clocklock", address_of(calls.pthread_mutex_clocklock)},
      {"pthread_mutex_unlock", address_of(calls.pthread_mutex_unlock)},
      {"pthread_cond_wait", address_of(calls.pthread_cond_wait)},
      {"pthread_cond_timedwait", address_of(calls.pthread_cond_timedwait)},
      {"pthread_cond_clockwait", address_of(calls.pthread_cond_clockwait)},
      {"pthread_cond_signal", address_of(calls.pthread_cond_signal)},
      {"pthread_cond_broadcast", address_of(calls.pthread_cond_broadcast)},
      {"pthread_rwlock_rdlock", address_of(calls.pthread_rwlock_rdlock)},
      {"pthread_rwlock_wrlock", address_of(calls.pthread_rwlock_wrlock)},
      {"pthread_rwlock_timedrdlock", address_of(calls.pthread_rwlock_timedrdlock)},
      {"pthread_rwlock_timedwrlock", address_of(calls.pthread_rwlock_timedwrlock)},
      {"pthread_rwlock_clockrdlock", address_of(calls.pthread_rwlock_clockrdlock)},
      {"pthread_rwlock_clockwrlock", address_of(calls.pthread_rwlock_clockwrlock)},
      {"pthread_rwlock_unlock", address_of(calls.pthread_rwlock_unlock)},
      {"pthread_cancel", address_of(calls.pthread_cancel)},
      {"pthread_barrier_wait", address_of(calls.pthread_barrier_wait)},
      {"sem_wait", address_of(calls.sem_wait)},
      {"sem_timedwait", address_of(calls.sem_timedwait)},
      {"sem_clockwait", address_of(calls.sem_clockwait)},
      {"sem_post", address_of(calls.sem_post)},
      {"fork", address_of(calls.fork)},
      {"vfork", address_of(calls.vfork)},
      {"posix_spawn", address_of(calls.posix_spawn)},
      {"posix_spawnp", address_of(calls.posix_spawnp)},
      {"system", address_of(calls.system)},
      {"popen", address_of(calls.popen)},
      {"pclose", address_of(calls.pclose)},
      {"daemon", address_of(calls.daemon)},
      {"execve", address_of(calls.execve)},
      {"execvpe", address_of(calls.execvpe)},
      {"fexecve", address_of(calls.fexecve)},
      {"execveat", address_of(calls.execveat)},
      {"waitpid", address_of(calls.waitpid)},
      {"wait4", address_of(calls.wait4)},
      {"waitid", address_of(calls.waitid)},
      {"_exit", address_of(calls.exit_at_once)},
      {"siglongjmp", address_of(calls.longjmp)},
      {"__longjmp_chk", address_of(calls.longjmp_chk)},
      {"close_range", address_of(calls.close_range)},
      {"closefrom", address_of(calls.closefrom)},
      {"dup2", address_of(calls.dup2)},
      {"dup3", address_of(calls.dup3)},
      {"fdopen", address_of(calls.fdopen)},
      {"fgetc", address_of(calls.fgetc)},
      {"getc_unlocked", address_of(calls.getc_unlocked)},
      {"__uflow", address_of(calls.uflow)},
      {"__underflow", address_of(calls.underflow)},
      {"__isoc99_vfscanf", address_of(calls.vfscanf)},
      {"fgets", address_of(calls.fgets)},
      {"getdelim", address_of(calls.getdelim)},
      {"fread", address_of(calls.fread)},
      {"syscall", address_of(calls.syscall)},
  };
  static_assert(sizeof entries / sizeof *entries == sizeof(Real) / sizeof(void*), "every call is looked up");
  look_up_all(entries);
  real_known.store(true, std::memory_order_release);
}

}  // namespace

const Real& real() noexcept {
  if (!real_known.load(std::memory_order_acquire)) look_up_real();
  return real_calls;
}

}  // namespace preload
