#pragma once

#include "core/base/file.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <thread>

namespace normalscope {

/// Saves the two versions in turn in another process, which is killed in the middle of it, again and again: the file
/// must always be the one or the other. Gives how many of the two it was seen to be.
inline std::size_t killed_while_saving(const std::filesystem::path& file,
                                       const std::function<void(int version)>& save) {
    std::array<std::string, 2> versions;
    for (const int v : {1, 0}) {
        save(v);
        versions[static_cast<std::size_t>(v)] = read_file(file, 1 << 26);
    }
    EXPECT_NE(versions[0], versions[1]);
    std::set<std::string> seen;
    std::mt19937 random(1);
    for (int round = 0; round < 50; ++round) {
        const pid_t child = ::fork();
        if (child == 0)
            for (int i = round + 1;; ++i) save(i % 2);
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 12'000));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const std::string found = read_file(file, 1 << 26);
        EXPECT_TRUE(found == versions[0] || found == versions[1])
            << "round " << round << ": " << found.size() << " bytes, and not those of a version";
        seen.insert(found);
    }
    return seen.size();
}

}  // namespace normalscope
