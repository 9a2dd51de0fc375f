#include "can/preload/time/base/real.hpp"

#include <atomic>

#include <dlfcn.h>

namespace preload {

namespace {

struct RealEntry {
  const char* name;
  void** address;
};

Real real_calls;
std::atomic<bool> real_known;

template <class Function>
void** room_of(Function*& call) noexcept {
  return reinterpret_cast<void**>(&call);
}

/// Threads that come here at the same time write the same.
void look_up_real() noexcept {
  Real& calls = real_calls;
  const RealEntry entries[] = {
      {"clock_gettime", room_of(calls.clock_gettime)},
      {"gettimeofday", room_of(calls.gettimeofday)},
      {"time", room_of(calls.time)},
      {"timespec_get", room_of(calls.timespec_get)},
      {"nanosleep", room_of(calls.nanosleep)},
      {"clock_nanosleep", room_of(calls.clock_nanosleep)},
      {"usleep", room_of(calls.usleep)},
      {"sleep", room_of(calls.sleep)},
      {"sched_yield", room_of(calls.sched_yield)},
      {"poll", room_of(calls.poll)},
      {"ppoll", room_of(calls.ppoll)},
      {"select", room_of(calls.select)},
      {"pselect", room_of(calls.pselect)},
      {"epoll_wait", room_of(calls.epoll_wait)},
      {"epoll_pwait", room_of(calls.epoll_pwait)},
      {"epoll_pwait2", room_of(calls.epoll_pwait2)},
      {"accept", room_of(calls.accept)},
      {"accept4", room_of(calls.accept4)},
      {"timerfd_create", room_of(calls.timerfd_create)},
      {"timerfd_settime", room_of(calls.timerfd_settime)},
      {"timerfd_gettime", room_of(calls.timerfd_gettime)},
      {"setitimer", room_of(calls.setitimer)},
      {"getitimer", room_of(calls.getitimer)},
      {"alarm", room_of(calls.alarm)},
      {"timer_create", room_of(calls.timer_create)},
      {"timer_settime", room_of(calls.timer_settime)},
      {"timer_gettime", room_of(calls.timer_gettime)},
      {"timer_getoverrun", room_of(calls.timer_getoverrun)},
      {"timer_delete", room_of(calls.timer_delete)},
      {"sigtimedwait", room_of(calls.sigtimedwait)},
      {"sigwaitinfo", room_of(calls.sigwaitinfo)},
      {"sigwait", room_of(calls.sigwait)},
      {"sigsuspend", room_of(calls.sigsuspend)},
      {"pause", room_of(calls.pause)},
      {"kill", room_of(calls.kill)},
      {"sigqueue", room_of(calls.sigqueue)},
      {"pthread_create", room_of(calls.pthread_create)},
      {"pthread_join", room_of(calls.pthread_join)},
      {"pthread_timedjoin_np", room_of(calls.pthread_timedjoin_np)},
      {"pthread_clockjoin_np", room_of(calls.pthread_clockjoin_np)},
      {"pthread_mutex_lock", room_of(calls.pthread_mutex_lock)},
      {"pthread_mutex_timedlock", room_of(calls.pthread_mutex_timedlock)},
      {"pthread_mutex_clocklock", room_of(calls.pthread_mutex_clocklock)},
      {"pthread_mutex_unlock", room_of(calls.pthread_mutex_unlock)},
      {"pthread_cond_wait", room_of(calls.pthread_cond_wait)},
      {"pthread_cond_timedwait", room_of(calls.pthread_cond_timedwait)},
      {"pthread_cond_clockwait", room_of(calls.pthread_cond_clockwait)},
      {"pthread_cond_signal", room_of(calls.pthread_cond_signal)},
      {"pthread_cond_broadcast", room_of(calls.pthread_cond_broadcast)},
      {"pthread_rwlock_rdlock", room_of(calls.pthread_rwlock_rdlock)},
      {"pthread_rwlock_wrlock", room_of(calls.pthread_rwlock_wrlock)},
      {"pthread_rwlock_timedrdlock", room_of(calls.pthread_rwlock_timedrdlock)},
      {"pthread_rwlock_timedwrlock", room_of(calls.pthread_rwlock_timedwrlock)},
      {"pthread_rwlock_clockrdlock", room_of(calls.pthread_rwlock_clockrdlock)},
      {"pthread_rwlock_clockwrlock", room_of(calls.pthread_rwlock_clockwrlock)},
      {"pthread_rwlock_unlock", room_of(calls.pthread_rwlock_unlock)},
      {"pthread_cancel", room_of(calls.pthread_cancel)},
      {"pthread_barrier_wait", room_of(calls.pthread_barrier_wait)},
      {"sem_wait", room_of(calls.sem_wait)},
      {"sem_timedwait", room_of(calls.sem_timedwait)},
      {"sem_clockwait", room_of(calls.sem_clockwait)},
      {"sem_post", room_of(calls.sem_post)},
      {"fork", room_of(calls.fork)},
      {"vfork", room_of(calls.vfork)},
      {"posix_spawn", room_of(calls.posix_spawn)},
      {"posix_spawnp", room_of(calls.posix_spawnp)},
      {"system", room_of(calls.system)},
      {"popen", room_of(calls.popen)},
      {"pclose", room_of(calls.pclose)},
      {"daemon", room_of(calls.daemon)},
      {"execve", room_of(calls.execve)},
      {"execvpe", room_of(calls.execvpe)},
      {"fexecve", room_of(calls.fexecve)},
      {"execveat", room_of(calls.execveat)},
      {"waitpid", room_of(calls.waitpid)},
      {"wait4", room_of(calls.wait4)},
      {"waitid", room_of(calls.waitid)},
      {"_exit", room_of(calls._exit)},
      {"siglongjmp", room_of(calls.longjmp)},
      {"__longjmp_chk", room_of(calls.longjmp_chk)},
      {"close_range", room_of(calls.close_range)},
      {"closefrom", room_of(calls.closefrom)},
      {"dup2", room_of(calls.dup2)},
      {"dup3", room_of(calls.dup3)},
      {"fdopen", room_of(calls.fdopen)},
      {"fgetc", room_of(calls.fgetc)},
      {"getc_unlocked", room_of(calls.getc_unlocked)},
      {"__uflow", room_of(calls.uflow)},
      {"__underflow", room_of(calls.underflow)},
      {"__isoc99_vfscanf", room_of(calls.vfscanf)},
      {"fgets", room_of(calls.fgets)},
      {"getdelim", room_of(calls.getdelim)},
      {"fread", room_of(calls.fread)},
      {"syscall", room_of(calls.syscall)},
  };
  static_assert(sizeof entries / sizeof *entries == sizeof(Real) / sizeof(void*), "every call is looked up");
  for (const RealEntry& entry : entries) *entry.address = dlsym(RTLD_NEXT, entry.name);
  real_known.store(true, std::memory_order_release);
}

}  // namespace

const Real& real() noexcept {
  if (!real_known.load(std::memory_order_acquire)) look_up_real();
  return real_calls;
}

}  // namespace preload
