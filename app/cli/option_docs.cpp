// Writes what is installed beside the program, from its one list of options: option_docs FOLDER.

#include "cli/help.h"
#include "core/base/file.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    using namespace normalscope;
    if (argc != 2) return std::fputs("usage: option_docs FOLDER\n", stderr), 2;
    try {
        const std::filesystem::path folder = argv[1];
        write_file(folder / "normalscope.1", manual_page());
        write_file(folder / "normalscope", bash_completion());
        write_file(folder / "_normalscope", zsh_completion());
        write_file(folder / "normalscope.fish", fish_completion());
    } catch (const std::exception& e) {
        return std::fprintf(stderr, "option_docs: %s\n", e.what()), 1;
    }
}
