// Simulates disk failures in a program that preloads it, as set by FAULT="CALL:N:HOW". CALL is pwrite,
// fallocate, fsync, rename or statvfs. From the N-th call on, it fails with HOW (ENOSPC, EIO, EACCES);
// statvfs reports no free space instead. With KILL or KILL_AFTER, the process is killed before or
// after the N-th call is executed, as by a power failure.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/statvfs.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

struct Fault {
    char call[16] = "", how[16] = "";
    int from = 0;

    Fault() {
        if (const char* text = std::getenv("FAULT")) std::sscanf(text, "%15[^:]:%d:%15s", call, &from, how);
    }
    bool is(const char* name) const { return std::strcmp(how, name) == 0; }
    int error() const { return is("ENOSPC") ? ENOSPC : is("EACCES") ? EACCES : EIO; }
};

std::atomic<int> calls{0};

/// The result of the real call, or the simulated failure.
template <class Real>
auto faulty(const char* name, Real real) -> decltype(real()) {
    static const Fault fault;
    if (std::strcmp(fault.call, name) != 0) return real();
    const int n = ++calls;
    if (n == fault.from && fault.is("KILL")) ::kill(::getpid(), SIGKILL);
    if (n == fault.from && fault.is("KILL_AFTER")) {
        real();
        ::kill(::getpid(), SIGKILL);
    }
    if (n < fault.from || fault.is("KILL") || fault.is("KILL_AFTER")) return real();
    errno = fault.error();
    return -1;
}

template <class F>
F* next(const char* name) {
    return reinterpret_cast<F*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
    return faulty("pwrite", [&] {
        return next<ssize_t(int, const void*, size_t, off_t)>("pwrite")(fd, data, size, at);
    });
}
ssize_t pwrite64(int fd, const void* data, size_t size, off64_t at) {
    return faulty("pwrite", [&] {
        return next<ssize_t(int, const void*, size_t, off64_t)>("pwrite64")(fd, data, size, at);
    });
}
int posix_fallocate(int fd, off_t from, off_t size) {
    const int result =
        faulty("fallocate", [&] { return next<int(int, off_t, off_t)>("posix_fallocate")(fd, from, size); });
    return result < 0 ? errno : result;
}
int statvfs(const char* path, struct statvfs* out) {
    const int result = next<int(const char*, struct statvfs*)>("statvfs")(path, out);
    if (faulty("statvfs", [] { return 0; }) < 0) out->f_bavail = 0;  // no free space
    return result;
}
int fsync(int fd) {
    return faulty("fsync", [&] { return next<int(int)>("fsync")(fd); });
}
int rename(const char* from, const char* to) {
    return faulty("rename", [&] { return next<int(const char*, const char*)>("rename")(from, to); });
}
}
