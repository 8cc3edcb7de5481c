// SPDX-License-Identifier: Apache-2.0
/// An executor on the standard library's threads.
#ifndef CLEAVE_EXECUTION_THREAD_POOL_HPP
#define CLEAVE_EXECUTION_THREAD_POOL_HPP

#include <cleave/base/contract.hpp>
#include <cleave/execution/executor.hpp>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

CLEAVE_BEGIN_NAMESPACE

/// Runs pieces on a fixed number of threads, one of which is the caller's. Threads that have nothing to do sleep.
///
/// Work may come from several threads at once, and from pieces that are running: whoever asks for work takes part in it
/// until no piece is left to start, so it never waits for a piece that nobody has started; while it waits for the
/// others it takes part in what their pieces ask for. Pieces are handed out one by one in ascending order. Once a piece
/// has thrown no other is started.
class ThreadPool {
public:
    /// As many threads as the machine offers.
    ThreadPool() : ThreadPool(std::max<std::size_t>(1, std::thread::hardware_concurrency())) {}

    /// Requires: threads >= 1. Throws: std::system_error where no more threads can be had.
    explicit ThreadPool(std::size_t threads) {
        CLEAVE_REQUIRES(threads >= 1);
        workers_.reserve(threads - 1);
        try {
            while (workers_.size() + 1 < threads) workers_.emplace_back([this] { work(); });
        } catch (...) {
            end_workers();
            throw;
        }
    }

    /// Requires: no work is running.
    ~ThreadPool() { end_workers(); }

    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    [[nodiscard]] std::size_t concurrency() const noexcept { return workers_.size() + 1; }

    template <class F, class G>
    void invoke(F&& f, G&& g) const {
        for_each_index(2, [&](std::size_t i) {
            if (i == 0)
                f();
            else
                g();
        });
    }

    template <class F>
    void for_each_index(std::size_t n, F&& f) const {
        if (n < 2 || workers_.empty()) {
            SequentialExecutor().for_each_index(n, f);
            return;
        }
        using Piece = std::remove_reference_t<F>;
        const auto call = [](const void* piece, std::size_t i) { (*static_cast<Piece*>(const_cast<void*>(piece)))(i); };
        Job job(n, &f, call);
        run(job);
    }

private:
    /// Pieces that were asked for by one call, which keeps the object alive until they have ended.
    struct Job {
        Job(std::size_t n, const void* f, void (*c)(const void*, std::size_t)) : count(n), piece(f), call(c) {}

        /// Whether a piece of `other`, or of a job within it, asked for this job.
        [[nodiscard]] bool is_within(const Job& other) const {
            const Job* j = parent;
            while (j != nullptr && j != &other) j = j->parent;
            return j != nullptr;
        }

        const std::size_t count;
        const void* const piece;
        void (*const call)(const void*, std::size_t);
        Job* const parent = running_;  // one of whose pieces asked for this job; it may be another pool's
        std::atomic<std::size_t> next = 0;
        std::size_t helpers = 0;         // threads in it besides the caller's; under the pool's mutex, like the rest
        std::exception_ptr error;        // the first
        std::condition_variable change;  // for the caller: a helper has left, or there is a job within this one
    };

    void run(Job& job) const {
        std::unique_lock<std::mutex> lock(mutex_);
        jobs_.push_back(&job);
        const std::size_t wanted = std::min(sleepers_, job.count - 1);
        for (Job* j = job.parent; j != nullptr; j = j->parent) j->change.notify_one();
        lock.unlock();
        for (std::size_t i = 0; i < wanted; ++i) wake_.notify_one();
        draw_pieces(job);
        lock.lock();
        std::erase(jobs_, &job);
        while (job.helpers != 0) {
            // Not any job: the caller of this one should not have to wait for work that has nothing to do with it.
            const auto inner = std::find_if(jobs_.rbegin(), jobs_.rend(), [&](const Job* j) {
                return j->next.load() < j->count && j->is_within(job);
            });
            if (inner != jobs_.rend())
                help(**inner, lock);
            else
                job.change.wait(lock);
        }
        lock.unlock();
        if (job.error) std::rethrow_exception(job.error);
    }

    /// Takes part in a job that another thread runs. The job may be gone once this has returned and the mutex is free.
    void help(Job& job, std::unique_lock<std::mutex>& lock) const {
        ++job.helpers;
        lock.unlock();
        draw_pieces(job);
        lock.lock();
        --job.helpers;
        job.change.notify_one();
    }

    /// Runs pieces until none is left to start.
    void draw_pieces(Job& job) const {
        Job* const outer = std::exchange(running_, &job);
        try {
            for (std::size_t i; (i = job.next.fetch_add(1)) < job.count;) job.call(job.piece, i);
        } catch (...) {
            job.next = job.count;
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!job.error) job.error = std::current_exception();
        }
        running_ = outer;
    }

    /// The life of a worker: the youngest job first, because older ones may wait for it.
    void work() {
        std::unique_lock<std::mutex> lock(mutex_);
        while (!ended_) {
            while (!jobs_.empty() && jobs_.back()->next.load() >= jobs_.back()->count) jobs_.pop_back();
            if (!jobs_.empty()) {
                help(*jobs_.back(), lock);
                continue;
            }
            ++sleepers_;
            wake_.wait(lock);
            --sleepers_;
        }
    }

    void end_workers() {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            ended_ = true;
        }
        wake_.notify_all();
        for (std::thread& worker : workers_) worker.join();
    }

    /// The job that the running piece belongs to, nullptr outside of pieces.
    static inline thread_local Job* running_ = nullptr;

    // To hand out pieces is no change that a user of the executor could see.
    mutable std::mutex mutex_;  // of the next four
    mutable std::condition_variable wake_;
    mutable std::vector<Job*> jobs_;
    mutable std::size_t sleepers_ = 0;
    bool ended_ = false;
    std::vector<std::thread> workers_;
};

CLEAVE_END_NAMESPACE

#endif
