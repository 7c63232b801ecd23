#!/usr/bin/env bash
# Where no thread can be started, a verb says so and ends with exit code 8, and what was there stays as it was.
. "$(dirname "$0")/scratch.sh"
[ -z "$SANITIZE" ] || skip "sanitizers start threads of their own"
"$CXX" -shared -fPIC -x c++ -o no_threads.so - <<'CODE' || skip "no compiler for what stands in for a system without threads"
#include <cerrno>
#include <cstdlib>
#include <dlfcn.h>
#include <pthread.h>
// As pthread_create, but that only the first THREADS calls succeed.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  static int left = std::atoi(std::getenv("THREADS"));
  if (--left < 0) return EAGAIN;
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, run, argument);
}
CODE
listing . > ../threads.before
for threads in 0 1 2 3 4 5 6 7 8 9 10 12; do
  code=0
  THREADS=$threads LD_PRELOAD=$PWD/no_threads.so "$TEXBAKE" bake pebbles.png -o a.texbundle --threads 4 > ../threads.out \
    2> ../threads.err || code=$?
  cat ../threads.err
  [ "$code" -eq 8 ] || { [ "$code" -eq 0 ] && [ "$threads" -ge 4 ]; } || fail "$threads threads: exit code $code, expected 8"
  [ "$code" -eq 0 ] || grep -q '^texbake: ' ../threads.err || fail "$threads threads: no message"
  rm -rf a.texbundle
  listing . > ../threads.after
  diff ../threads.before ../threads.after || fail "$threads threads: files are left"
done
