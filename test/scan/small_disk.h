#pragma once

#include <signal.h>
#include <sys/resource.h>

/// While it lives no file of this process can grow beyond a size: write fails as on a full disk, for root too.
class SmallDisk
{
public:
  explicit SmallDisk(rlim_t bytes)
  {
    old_handler_ = signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_limit_);
    rlimit limit = old_limit_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk()
  {
    setrlimit(RLIMIT_FSIZE, &old_limit_);
    signal(SIGXFSZ, old_handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

private:
  rlimit old_limit_{};
  void (*old_handler_)(int) = nullptr;
};
