// SPDX-License-Identifier: Apache-2.0
// Memory of volumes: reused, never more than was in use, given back.
#include "base/block_pool.hpp"

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <thread>
#include <vector>

#include "xgm/base/aligned_buffer.hpp"
#include "xgm/base/memory.hpp"
#include "xgm/base/parallel.hpp"

using namespace xgm;

namespace {

constexpr std::size_t kMega = std::size_t{1} << 20;

/// Page faults that memory used again may have. With a sanitizer they cannot be told from
/// those of its own books.
#ifdef XGM_SANITIZED
constexpr long kFewFaults = std::numeric_limits<long>::max();
#else
constexpr long kFewFaults = 4;
#endif

/// Minor page faults of what `body` does.
template <class Body>
long faults_of(Body body) {
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  body();
  getrusage(RUSAGE_SELF, &after);
  return after.ru_minflt - before.ru_minflt;
}

/// What `body` returns in a process of its own, which may be limited; -1 if that dies.
template <class Body>
int in_child(Body body) {
  const pid_t child = fork();
  if (child == 0) _exit(body());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("blocks are aligned to huge pages and keep what is written") {
  BlockPool pool;
  for (const std::size_t bytes : {std::size_t{1}, kHugePage, kHugePage + 1, 5 * kHugePage}) {
    std::byte* const block = pool.take(bytes);
    CHECK(reinterpret_cast<std::uintptr_t>(block) % kHugePage == 0);
    std::memset(block, 7, bytes);
    CHECK(std::all_of(block, block + bytes, [](std::byte b) { return b == std::byte{7}; }));
    pool.give_back(block);
  }
}

TEST_CASE("a block is used again without page faults, also by a smaller and a larger volume") {
  BlockPool pool;
  const auto use = [&](std::size_t bytes) {
    return faults_of([&] {
      std::byte* const block = pool.take(bytes);
      std::memset(block, 1, bytes);
      pool.give_back(block);
    });
  };
  CHECK(use(64 * kMega) > 0);
  CHECK(use(64 * kMega) <= kFewFaults);
  CHECK(use(60 * kMega) <= kFewFaults);
  CHECK(use(62 * kMega) <= kFewFaults);
}

TEST_CASE("the volumes of a second view that are a little larger cost next to no page faults") {
  BlockPool pool;
  const auto view = [&](std::size_t costs) {
    return faults_of([&] {
      std::byte* const first = pool.take(costs);
      std::memset(first, 1, costs);
      std::byte* const second = pool.take(2 * costs);
      std::memset(second, 1, 2 * costs);
      pool.give_back(first);
      pool.give_back(second);
    });
  };
  const long first = view(100 * kMega);
  CHECK(view(102 * kMega) <= std::max(first / 10, kFewFaults));
  CHECK(view(97 * kMega) <= std::max(first / 10, kFewFaults));
}

TEST_CASE("a larger block is made of a kept piece, whose content it has, and of new memory") {
  BlockPool pool;
  std::byte* const small = pool.take(4 * kMega);
  std::memset(small, 3, 4 * kMega);
  pool.give_back(small);
  CHECK(pool.kept_bytes() == 4 * kMega);
  std::byte* const large = pool.take(10 * kMega);
  CHECK(pool.kept_bytes() == 0);
  CHECK(pool.used_bytes() == 10 * kMega);
  CHECK(large[4 * kMega - 1] == std::byte{3});
  std::memset(large, 4, 10 * kMega);
  pool.give_back(large);
  CHECK(pool.kept_bytes() == 10 * kMega);
}

TEST_CASE("blocks of any sizes are put together of what others left, without page faults") {
  BlockPool pool;
  const auto use_together = [&](const std::vector<std::size_t>& sizes) {
    return faults_of([&] {
      std::vector<std::byte*> blocks;
      for (const std::size_t bytes : sizes) {
        blocks.push_back(pool.take(bytes));
        std::memset(blocks.back(), 1, bytes);
      }
      for (std::byte* const block : blocks) pool.give_back(block);
    });
  };
  CHECK(use_together({100 * kMega, 200 * kMega}) > 0);
  CHECK(use_together({10 * kMega, 20 * kMega, 40 * kMega}) <= kFewFaults);
  CHECK(use_together({100 * kMega, 200 * kMega}) <= kFewFaults);
  CHECK(use_together({60 * kMega, 240 * kMega}) <= kFewFaults);
  CHECK(use_together({200 * kMega, 70 * kMega, 30 * kMega}) <= kFewFaults);
  CHECK(pool.kept_bytes() == 300 * kMega);
}

TEST_CASE("free and used blocks together are never more than was in use at once") {
  BlockPool pool;
  std::vector<std::byte*> used;
  std::size_t most = 0;
  std::uint64_t state = 1;
  const auto random = [&](std::size_t below) {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state >> 33) % below;
  };
  for (int round = 0; round < 2000; ++round) {
    if (used.size() < 4 && random(2) == 0) {
      const std::size_t bytes = 1 + random(30 * kMega);
      used.push_back(pool.take(bytes));
    } else if (!used.empty()) {
      const auto chosen = used.begin() + static_cast<std::ptrdiff_t>(random(used.size()));
      pool.give_back(*chosen);
      used.erase(chosen);
    }
    most = std::max(most, pool.used_bytes());
    REQUIRE(pool.used_bytes() + pool.kept_bytes() <= most);
  }
  for (std::byte* const block : used) pool.give_back(block);
  CHECK(pool.used_bytes() == 0);
  pool.trim();
  CHECK(pool.kept_bytes() == 0);
}

TEST_CASE("without memory: std::bad_alloc, but first the free blocks are dropped") {
  const int outcome = in_child([] {
    BlockPool pool;
    std::byte* const block = pool.take(400 * kMega);
    std::byte* const other = pool.take(40 * kMega);
    pool.give_back(block);
    limit_memory(100 * kMega);
    // The kept piece is not enough, and what is missing does not exist as long as it is kept.
    std::byte* const next = pool.take(450 * kMega);
    pool.give_back(next);
    try {
      pool.take(2000 * kMega);
    } catch (const std::bad_alloc&) {
      pool.give_back(other);
      return pool.kept_bytes() == 40 * kMega ? 0 : 2;
    }
    return 1;
  });
  CHECK(outcome == 0);
  BlockPool pool;
  CHECK_THROWS_AS(pool.take(SIZE_MAX), std::bad_alloc);
  CHECK_THROWS_AS(pool.take(SIZE_MAX / 4), std::bad_alloc);
}

namespace {

constexpr std::size_t kVolume = 64 * kMega;

void use_volume() {
  const AlignedBuffer cells = new_buffer(kVolume);
  std::memset(cells.get(), 1, kVolume);
}

template <class Body>
void in_another_thread(Body body) {
  std::thread(body).join();
}

}  // namespace

TEST_CASE("volumes reuse memory while a BufferReuse lives, and give it back afterwards") {
  use_volume();
  CHECK(faults_of(use_volume) > 2);  // nothing is kept outside of runs
  const std::uint64_t before = resident_memory();
  {
    const BufferReuse run;
    use_volume();
    {
      const BufferReuse part_of_it;
      CHECK(faults_of(use_volume) <= kFewFaults);
    }
    CHECK(faults_of(use_volume) <= kFewFaults);
    CHECK(resident_memory() > before + kVolume / 2);
  }
  CHECK(resident_memory() < before + kVolume / 2);
}

TEST_CASE("memory that a run keeps is used by the threads of its loops, and by no other run") {
  const ThreadLimit threads(2);
  const BufferReuse run;
  parallel_for(0, 2, [](int) { use_volume(); });
  CHECK(faults_of([] { parallel_for(0, 1, [](int) { use_volume(); }); }) <= kFewFaults);
  in_another_thread([] {
    CHECK(faults_of(use_volume) > 2);
    const BufferReuse other_run;
    CHECK(faults_of(use_volume) > 2);
  });
  CHECK(faults_of(use_volume) <= kFewFaults);
}

TEST_CASE("a volume that another thread frees comes back to the run that it is from") {
  const BufferReuse run;
  AlignedBuffer cells = new_buffer(kVolume);
  std::memset(cells.get(), 1, kVolume);
  in_another_thread([&] {
    const BufferReuse other_run;
    cells.reset();
    CHECK(faults_of(use_volume) > 2);
  });
  CHECK(faults_of(use_volume) <= kFewFaults);
}

TEST_CASE("a volume that outlives its run is freed by any thread, to the system") {
  AlignedBuffer kept;
  const std::uint64_t before = resident_memory();
  {
    const BufferReuse run;
    kept = new_buffer(kVolume);
    std::memset(kept.get(), 1, kVolume);
  }
  CHECK(resident_memory() > before + kVolume / 2);
  in_another_thread([&] { kept.reset(); });
  CHECK(resident_memory() < before + kVolume / 2);
}

TEST_CASE("cells of any size are aligned, and may outlive a run") {
  AlignedBuffer kept;
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, std::size_t{5000}, 20 * kMega}) {
    const BufferReuse run;
    kept = new_buffer(bytes);
    CHECK(reinterpret_cast<std::uintptr_t>(kept.get()) % kBufferAlignment == 0);
  }
  std::memset(kept.get(), 1, 20 * kMega);
}
