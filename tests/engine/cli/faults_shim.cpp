// SPDX-License-Identifier: BSD-3-Clause
/// Preloaded into a program it makes the n-th call of a kind fail, once or from then on. From the
/// moment the program takes its standard streams.
///
/// SCARP_FAULT_KIND: memory (of C++), open, write, sync or rename. Memory that stays gone is gone
/// but for what the program's new-handler gave back, counted as 1 MiB. SCARP_FAULT_AT: the call
/// that fails, 0 for none; SCARP_FAULT_STAYS: set if all later ones do. SCARP_FAULT_COUNT: file
/// that is told at the end how many calls there were.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

std::atomic<bool> armed = false;
std::atomic<long> calls = 0;
std::atomic<long> given_back = 0;  // of memory [B]
std::atomic<bool> told = false;    // the new-handler

bool fails(const char* kind) {
  if (!armed) return false;
  static const char* const wanted = std::getenv("SCARP_FAULT_KIND");
  static const char* const number = std::getenv("SCARP_FAULT_AT");
  static const bool stays = std::getenv("SCARP_FAULT_STAYS") != nullptr;
  if (wanted == nullptr || number == nullptr || std::strcmp(wanted, kind) != 0) return false;
  const long at = std::atol(number), call = ++calls;
  return at > 0 && (call == at || (stays && call > at));
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// Takes from what has been given back.
bool is_covered(std::size_t size) {
  const long asked = static_cast<long>(size);
  return given_back.fetch_sub(asked) >= asked;
}

void* made(std::size_t size, std::size_t alignment) {
  if (fails("memory") && !is_covered(size)) {
    if (const std::new_handler handler = std::get_new_handler(); handler && !told.exchange(true)) {
      given_back = 1 << 20;
      handler();
    }
    throw std::bad_alloc();
  }
  void* memory = nullptr;
  if (posix_memalign(&memory, alignment < sizeof(void*) ? sizeof(void*) : alignment, size) != 0)
    throw std::bad_alloc();
  return memory;
}

/// Standard streams are another test's.
bool write_fails(int descriptor) { return descriptor > 2 && fails("write"); }

int with_error(int error) {
  errno = error;
  return -1;
}

struct Count {
  ~Count() {
    armed = false;
    if (const char* path = std::getenv("SCARP_FAULT_COUNT")) {
      if (FILE* file = std::fopen(path, "w")) {
        std::fprintf(file, "%ld\n", calls.load());
        std::fclose(file);
      }
    }
  }
} count_at_the_end;

}  // namespace

void* operator new(std::size_t size) { return made(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return made(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

extern "C" {

FILE* fopencookie(void* cookie, const char* mode, cookie_io_functions_t functions) {
  armed = true;
  return real<decltype(fopencookie)>("fopencookie")(cookie, mode, functions);
}

int open(const char* path, int flags, ...) {
  if (fails("open")) return with_error(EMFILE);
  std::va_list rest;
  va_start(rest, flags);
  const unsigned mode = va_arg(rest, unsigned);
  va_end(rest);
  return real<int(const char*, int, ...)>("open")(path, flags, mode);
}
int open64(const char* path, int flags, ...) {
  if (fails("open")) return with_error(EMFILE);
  std::va_list rest;
  va_start(rest, flags);
  const unsigned mode = va_arg(rest, unsigned);
  va_end(rest);
  return real<int(const char*, int, ...)>("open64")(path, flags, mode);
}
FILE* fopen64(const char* path, const char* mode) {
  if (fails("open")) {
    errno = EMFILE;
    return nullptr;
  }
  return real<FILE*(const char*, const char*)>("fopen64")(path, mode);
}
ssize_t write(int descriptor, const void* data, std::size_t size) {
  if (write_fails(descriptor)) return with_error(ENOSPC);
  return real<ssize_t(int, const void*, std::size_t)>("write")(descriptor, data, size);
}
ssize_t writev(int descriptor, const iovec* parts, int count) {
  if (write_fails(descriptor)) return with_error(ENOSPC);
  return real<ssize_t(int, const iovec*, int)>("writev")(descriptor, parts, count);
}
int fsync(int descriptor) {
  if (fails("sync")) return with_error(EIO);
  return real<int(int)>("fsync")(descriptor);
}
int rename(const char* from, const char* to) {
  if (fails("rename")) return with_error(EACCES);
  return real<int(const char*, const char*)>("rename")(from, to);
}

}  // extern "C"
