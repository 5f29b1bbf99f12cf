#pragma once

// What the fuzzers share. Each defines `check`, which must come back, or throw InputError or UsageError, for any bytes;
// it aborts at a mistake. They are built in one of two ways:
//   - with Clang and -DNORMALSCOPE_LIBFUZZER=ON (the preset "fuzz") they are libFuzzer's:
//       build/fuzz/mesh_fuzz -max_total_time=600 build/corpus tests/fuzz/inputs/mesh
//   - otherwise they change the inputs in a folder themselves: mesh_fuzz FOLDER SECONDS [SEED]

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope::fuzz {

/// Defined by each fuzzer.
void check(std::string_view bytes);
/// What its inputs are made of, to be put in here and there.
std::vector<std::string_view> words();

/// Aborts, and names what does not hold.
inline void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "fuzz: %s\n", what);
    std::abort();
}

}  // namespace normalscope::fuzz
