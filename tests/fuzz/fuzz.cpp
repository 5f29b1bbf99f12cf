#include "fuzz.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <sys/resource.h>
#include <unistd.h>

using namespace normalscope;

#ifdef NORMALSCOPE_LIBFUZZER

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    fuzz::check({reinterpret_cast<const char*>(data), size});
    return 0;
}

#else

namespace {

constexpr std::size_t kLongest = 1 << 16;
constexpr unsigned kMostSeconds = 20;            // for one input, on a busy machine and with sanitizers
constexpr rlim_t kMostMemory = rlim_t{2} << 30;  // no input of kLongest bytes may need more

std::string current;

// The input that ended the program is worth keeping: put it among the inputs once the mistake is mended.
void keep_input(int number) {
    std::signal(number, SIG_DFL);
    if (std::FILE* file = std::fopen("fuzz-finding", "wb")) {
        std::fwrite(current.data(), 1, current.size(), file);
        std::fclose(file);
    }
    std::fputs("fuzz: the input is in fuzz-finding\n", stderr);
    std::raise(number);
}

class Mutator {
public:
    Mutator(const std::vector<std::string>& inputs, std::uint64_t seed)
        : inputs_(inputs), words_(fuzz::words()), random_(seed) {}

    std::string next() {
        std::string text = any(inputs_);
        for (std::size_t changes = 1 + below(6); changes > 0; --changes) change(text);
        text.resize(std::min(text.size(), kLongest));
        return text;
    }

private:
    std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }
    template <class List>
    const typename List::value_type& any(const List& list) {
        return list[below(list.size())];
    }

    void change(std::string& text) {
        const std::size_t at = below(text.size() + 1), length = std::min(below(16), text.size() - at);
        switch (below(8)) {
            case 0: text.insert(at, any(words_)); break;
            case 1: text.replace(at, length, any(words_)); break;
            case 2: text.erase(at, below(2) == 0 ? length : text.size() / 4); break;
            case 3: text.resize(at); break;
            case 4:  // a piece of itself or another input, maybe many times
            {
                const std::string& other = any(inputs_);
                const std::size_t from = below(other.size());
                const std::string piece = other.substr(from, below(64));
                for (std::size_t times = below(10) == 0 ? 50 : 1; times > 0; --times) text.insert(at, piece);
                break;
            }
            case 5:
                for (std::size_t i = at; i < at + length; ++i) text[i] = static_cast<char>(random_());
                break;
            default:
                if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        }
    }

    const std::vector<std::string>& inputs_;
    std::vector<std::string_view> words_;
    std::mt19937_64 random_;
};

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) return std::fputs("usage: FUZZER FOLDER SECONDS [SEED]\n", stderr), 2;
    for (const int number : {SIGABRT, SIGSEGV, SIGFPE, SIGALRM}) std::signal(number, keep_input);
#ifndef __SANITIZE_ADDRESS__  // which reserves terabytes
    const rlimit memory{kMostMemory, kMostMemory};
    ::setrlimit(RLIMIT_AS, &memory);
#endif
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<std::string> inputs{""};
    for (const auto& file : files) {
        std::ifstream in(file, std::ios::binary);
        inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }

    const auto run = [](std::string input) {
        current = std::move(input);
        ::alarm(kMostSeconds);
        fuzz::check(current);
    };
    for (const std::string& input : inputs) run(input);
    Mutator mutator(inputs, argc > 3 ? std::strtoull(argv[3], nullptr, 10) : std::random_device{}());
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(std::atoi(argv[2]));
    std::size_t rounds = 0;
    for (; std::chrono::steady_clock::now() < end; ++rounds) run(mutator.next());
    std::printf("%zu inputs, %zu made of them: nothing found\n", inputs.size(), rounds);
}

#endif
