#include "confinement.hpp"

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <initializer_list>
#include <new>

#include "creepcontact/io/msh/mesher_protocol.hpp"
#include "death.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define CREEPCONTACT_ADDRESS_SANITIZER 1
#endif
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CREEPCONTACT_ADDRESS_SANITIZER 1
#endif
#endif

namespace creepcontact::mesher {
namespace {

/// A system call that was trapped. Not safe in general, but the call was made on purpose, at a place of the program's
/// choice, and the process ends here.
extern "C" void end_for_reaching_out(int, siginfo_t* info, void*) {
  switch (info->si_syscall) {
    case SYS_clone:
    case SYS_execve:
    case SYS_execveat:
      report_line("the file tried to start a program");
      break;
    case SYS_socket:
      report_line("the file tried to open a network connection");
      break;
    default:
      report_line("the file tried to write, create, rename or remove a file");
  }
  report_place();
  _exit(io::mesher::reached_out);
}

class Filter {
 public:
  Filter() : context_(seccomp_init(SCMP_ACT_ALLOW)) {}
  ~Filter() { seccomp_release(context_); }
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  /// Calls that the machine does not have are skipped.
  void trap(std::initializer_list<int> calls) {
    for (int call : calls) seccomp_rule_add(context_, SCMP_ACT_TRAP, call, 0);
  }
  /// Calls whose argument has a bit of the mask set to that value.
  void trap(int call, scmp_arg_cmp argument) { seccomp_rule_add_array(context_, SCMP_ACT_TRAP, call, 1, &argument); }
  /// Whose arguments cannot be looked at: callers then use the older call.
  void hide(std::initializer_list<int> calls) {
    for (int call : calls) seccomp_rule_add(context_, SCMP_ACT_ERRNO(ENOSYS), call, 0);
  }
  /// Calls that fail as if they were not allowed.
  void deny(int call) { seccomp_rule_add(context_, SCMP_ACT_ERRNO(EACCES), call, 0); }
  bool load() { return seccomp_load(context_) == 0; }

 private:
  scmp_filter_ctx context_;
};

extern "C" void end_for_memory() {
  report_line("no memory is left");
  report_place();
  _exit(io::mesher::out_of_memory);
}

}  // namespace

bool confine(Network network) {
  Filter filter;
  filter.hide({SCMP_SYS(clone3), SCMP_SYS(openat2), SCMP_SYS(io_uring_setup)});
  // threads, which are clones that share everything, are let be
  filter.trap(SCMP_SYS(clone), SCMP_CMP(0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0));
  filter.trap({SCMP_SYS(fork), SCMP_SYS(vfork), SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(ptrace),
               SCMP_SYS(process_vm_writev)});
  if (network == Network::ends)
    filter.trap({SCMP_SYS(socket)});
  else
    filter.deny(SCMP_SYS(socket));
  for (const int flag : {O_WRONLY, O_RDWR, O_CREAT, O_TRUNC}) {
    filter.trap(SCMP_SYS(open),
                SCMP_CMP(1, SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(flag), static_cast<scmp_datum_t>(flag)));
    filter.trap(SCMP_SYS(openat),
                SCMP_CMP(2, SCMP_CMP_MASKED_EQ, static_cast<scmp_datum_t>(flag), static_cast<scmp_datum_t>(flag)));
  }
  filter.trap({SCMP_SYS(creat),
               SCMP_SYS(truncate),
               SCMP_SYS(mkdir),
               SCMP_SYS(mkdirat),
               SCMP_SYS(rmdir),
               SCMP_SYS(unlink),
               SCMP_SYS(unlinkat),
               SCMP_SYS(rename),
               SCMP_SYS(renameat),
               SCMP_SYS(renameat2),
               SCMP_SYS(link),
               SCMP_SYS(linkat),
               SCMP_SYS(symlink),
               SCMP_SYS(symlinkat),
               SCMP_SYS(mknod),
               SCMP_SYS(mknodat),
               SCMP_SYS(chmod),
               SCMP_SYS(fchmod),
               SCMP_SYS(fchmodat),
               SCMP_SYS(chown),
               SCMP_SYS(fchown),
               SCMP_SYS(lchown),
               SCMP_SYS(fchownat),
               SCMP_SYS(setxattr),
               SCMP_SYS(lsetxattr),
               SCMP_SYS(utime),
               SCMP_SYS(utimes),
               SCMP_SYS(utimensat),
               SCMP_SYS(mount),
               SCMP_SYS(kill),
               SCMP_SYS(tkill),
               SCMP_SYS(fsetxattr),
               SCMP_SYS(removexattr),
               SCMP_SYS(lremovexattr),
               SCMP_SYS(fremovexattr),
               SCMP_SYS(futimesat),
               SCMP_SYS(open_by_handle_at),
               SCMP_SYS(process_vm_readv),
               SCMP_SYS(rt_sigqueueinfo),
               SCMP_SYS(rt_tgsigqueueinfo),
               SCMP_SYS(umount2),
               SCMP_SYS(pivot_root),
               SCMP_SYS(chroot),
               SCMP_SYS(setns),
               SCMP_SYS(unshare),
               SCMP_SYS(bpf),
               SCMP_SYS(mq_open),
               SCMP_SYS(shmget)});
  struct sigaction action {};
  action.sa_sigaction = end_for_reaching_out;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSYS, &action, nullptr);
  return filter.load();
}

void limit_memory(int limit_mb) {
  std::set_new_handler(end_for_memory);
#ifndef CREEPCONTACT_ADDRESS_SANITIZER
  if (limit_mb == 0) return;
  rlim_t pages = 0;  // the libraries alone reserve most of a gigabyte
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t wanted = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (static_cast<rlim_t>(limit_mb) << 20);
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = std::min(limit.rlim_cur, std::min(limit.rlim_max, wanted));
  setrlimit(RLIMIT_AS, &limit);
#else
  static_cast<void>(limit_mb);
#endif
}

void be_expendable() {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  std::ofstream("/proc/self/oom_score_adj") << 1000;
}

}  // namespace creepcontact::mesher
