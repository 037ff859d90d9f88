// SPDX-License-Identifier: Apache-2.0
// Threads that share the items of a job by claiming them one by one, so that a core that is busy elsewhere delays no
// more than the item it holds.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace auslan::raster {

class Workers {
 public:
  /// Starts count - 1 threads, or as many as the system allows; the caller of `share` is one more.
  explicit Workers(int count);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int count() const noexcept { return static_cast<int>(threads_.size()) + 1; }

  /// Calls work(item, worker) for each item below `items` (at most kMostItems), in any order on any worker, and returns
  /// when all are done. `worker` is below count(), and no two calls run on one worker at a time.
  template <class Work>
  void share(uint32_t items, Work& work) {
    share(
        items, [](void* context, uint32_t item, int worker) { (*static_cast<Work*>(context))(item, worker); }, &work);
  }
  static constexpr uint32_t kMostItems = 1U << 19U;

 private:
  using Function = void (*)(void* context, uint32_t item, int worker);
  struct Job {
    Function function = nullptr;
    void* context = nullptr;
  };
  void share(uint32_t items, Function function, void* context);
  bool claim_and_run(int worker);
  void serve(int worker);

  // Each worker has a part of a job's items, the same part of the next frame's job, so that what it wrote last is still
  // in its cache; who has finished takes from the others' parts. One word tells which job it is, where the part ends
  // and which item is next, so that a claim is one addition. A worker that comes late may claim an item of a later job
  // than it looked for: it gets that job's item, which is as good.
  struct alignas(64) Part {
    std::atomic<uint64_t> ticket{0};
  };
  std::vector<Part> parts_;  ///< one a worker
  uint64_t job_ = 0;         ///< the last job's number
  Job jobs_[2];  ///< by the job's number, even and odd; one cannot be reused while an item of it is being worked on
  std::atomic<uint32_t> done_{0};
  std::atomic<uint32_t> wake_{0};  ///< changes when there is something to do
  std::atomic<int> asleep_{0};
  std::atomic<bool> stop_{false};
  std::vector<std::thread> threads_;
};

}  // namespace auslan::raster
