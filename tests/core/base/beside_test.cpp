#include "core/base/beside.h"

#include "core/base/error.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace normalscope {
namespace {

using namespace std::chrono_literals;

TEST(Beside, GivesWhatTheTaskGives) {
    Beside<std::string> task = beside([] { return std::string("done"); });
    EXPECT_TRUE(task);
    EXPECT_EQ(task.get(), "done");
    EXPECT_FALSE(task);
    EXPECT_EQ(beside([owned = std::make_unique<int>(3)] { return *owned; }).get(), 3);
}

TEST(Beside, ThrowsWhatTheTaskThrows) {
    for (const Begin begin : {Begin::AtOnce, Begin::WhenAsked}) {
        Beside<int> task = beside([]() -> int { throw InputError("no such file"); }, begin);
        EXPECT_THROW(task.get(), InputError);
        EXPECT_FALSE(task);
    }
}

TEST(Beside, IsReadyOnceTheTaskHasEnded) {
    std::atomic<bool> may_end = false;
    Beside<void> task = beside([&] {
        while (!may_end) {
        }
    });
    EXPECT_FALSE(task.ready());
    EXPECT_FALSE(task.ready(1ms));
    may_end = true;
    EXPECT_TRUE(task.ready(1min));
    task.get();
}

// As it is where there are no threads.
TEST(Beside, BeginsWhenAskedAndOnlyThen) {
    int runs = 0;
    {
        Beside<int> task = beside([&] { return ++runs; }, Begin::WhenAsked);
        EXPECT_TRUE(task.ready());
        EXPECT_EQ(runs, 0);
        EXPECT_EQ(task.get(), 1);
        task = beside([&] { return ++runs; }, Begin::WhenAsked);
    }
    EXPECT_EQ(runs, 1);
}

TEST(Beside, WhoeverLetsGoStopsTheTask) {
    std::atomic<int> ended = 0;
    const auto until_stopped = [&](const Stop& stop) {
        while (!stop.asked()) {
        }
        ++ended;
    };
    {
        Beside<void> task = beside(until_stopped);
        Beside<void> other = std::move(task);
        EXPECT_FALSE(task);  // NOLINT(bugprone-use-after-move): what it is then is told
        other = beside(until_stopped);
        EXPECT_EQ(ended, 1);
    }
    EXPECT_EQ(ended, 2);
    EXPECT_FALSE(Stop().asked());
}

TEST(Beside, ManyAtOnce) {
    std::vector<Beside<std::size_t>> tasks;
    for (std::size_t i = 0; i < 50; ++i) tasks.push_back(beside([i] { return i * i; }));
    for (std::size_t i = 0; i < tasks.size(); ++i) EXPECT_EQ(tasks[i].get(), i * i);
}

TEST(Beside, ThreadsForWorkOfItsSize) {
    EXPECT_GE(processors(), 1u);
    EXPECT_EQ(threads_for(0, 10), 1u);
    EXPECT_EQ(threads_for(19, 10), 1u);
    EXPECT_LE(threads_for(1'000'000, 10), std::min<std::size_t>(processors(), 4));
}

}  // namespace
}  // namespace normalscope
