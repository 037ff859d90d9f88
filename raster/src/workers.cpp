// SPDX-License-Identifier: Apache-2.0
#include "workers.h"

#include <system_error>

namespace auslan::raster {
namespace {

// ticket: job number | end of the part | next item
constexpr uint64_t kItemBits = 20;
constexpr uint64_t kItemMask = (uint64_t{1} << kItemBits) - 1U;

uint64_t next_item(uint64_t ticket) {
  return ticket & kItemMask;
}
uint64_t part_end(uint64_t ticket) {
  return ticket >> kItemBits & kItemMask;
}
uint64_t job_number(uint64_t ticket) {
  return ticket >> (2 * kItemBits);
}

// How often a worker looks for a next job before it sleeps: the pause between two jobs of a frame is short.
constexpr int kPatience = 2000;

void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

}  // namespace

Workers::Workers(int count) : parts_(static_cast<size_t>(count)) {
  threads_.reserve(static_cast<size_t>(count - 1));
  try {
    for (int worker = 1; worker < count; ++worker)
      threads_.emplace_back([this, worker] { serve(worker); });
  } catch (const std::system_error&) {
    // The system gives no more threads: those that run share the work.
  }
}

Workers::~Workers() {
  stop_.store(true);
  wake_.fetch_add(1);
  wake_.notify_all();
  for (std::thread& thread : threads_)
    thread.join();
}

void Workers::share(uint32_t items, Function function, void* context) {
  if (threads_.empty() || items < 2) {
    for (uint32_t item = 0; item < items; ++item)
      function(context, item, 0);
    return;
  }
  // The last job is done, so nobody reads its successor's place, which held the one before the last.
  const uint64_t number = ++job_;
  jobs_[number & 1U] = Job{function, context};
  done_.store(0);
  uint64_t begin = 0;
  for (size_t i = 0; i < parts_.size(); ++i) {
    const uint64_t end = uint64_t{items} * (i + 1) / parts_.size();
    parts_[i].ticket.store(number << (2 * kItemBits) | end << kItemBits | begin);
    begin = end;
  }
  wake_.fetch_add(1);
  if (asleep_.load() > 0) wake_.notify_all();
  while (claim_and_run(0)) {
  }
  for (int looks = 0; done_.load() != items; ++looks) {
    if (looks < kPatience) {
      relax();
    } else {
      std::this_thread::yield();
    }
  }
}

bool Workers::claim_and_run(int worker) {
  const size_t count = parts_.size();
  for (size_t i = 0, k = static_cast<size_t>(worker); i < count; ++i, k = k + 1 == count ? 0 : k + 1) {
    std::atomic<uint64_t>& part = parts_[k].ticket;
    const uint64_t seen = part.load();
    if (next_item(seen) >= part_end(seen)) continue;
    const uint64_t ticket = part.fetch_add(1);
    const uint64_t item = next_item(ticket);
    if (item >= part_end(ticket)) continue;
    const Job& job = jobs_[job_number(ticket) & 1U];
    job.function(job.context, static_cast<uint32_t>(item), worker);
    done_.fetch_add(1);
    return true;
  }
  return false;
}

void Workers::serve(int worker) {
  while (!stop_.load()) {
    const uint32_t before = wake_.load();
    bool worked = false;
    for (int looks = 0; looks < kPatience && !stop_.load(); ++looks) {
      if (claim_and_run(worker)) {
        worked = true;
        looks = 0;
      } else {
        relax();
      }
    }
    if (worked || stop_.load()) continue;
    asleep_.fetch_add(1);
    // A job that came since `before` was read has changed the word, and the wait ends at once.
    wake_.wait(before);
    asleep_.fetch_sub(1);
  }
}

}  // namespace auslan::raster
