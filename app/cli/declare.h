#pragma once

#include "cli/commands.h"

// What the declarations of the commands share. Each option is declared once, its help beside it.

#include <CLI/CLI.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace normalscope {

/// A declared command, and what its options make. Values stay text while CLI11 parses, and are read by `make`: CLI11's
/// own messages differ from version to version.
struct Declared {
    CLI::App* app;
    std::function<Command()> make;
};

/// "normalscope 0.1.0"
std::string version_text();
std::string text_of(glm::ivec2 size);
std::string text_of(double number);

/// What every command has, and how it treats its options.
void set_up(CLI::App& app, const std::string& examples);
/// An option or an argument; what is in `value` already is its default.
CLI::Option& add(CLI::App& app, const std::string& name, std::string& value, const std::string& word,
                 const std::string& help);
/// One that may be given again and again.
CLI::Option& add_list(CLI::App& app, const std::string& name, std::vector<std::string>& value, const std::string& word,
                      const std::string& help);
CLI::Option& add_file(CLI::App& app, std::string& value);
void add_settings(CLI::App& app, std::vector<std::string>& value);

void add_lesson_folders(CLI::App& app, std::vector<std::string>& value);
void add_context(CLI::App& app, std::string& value);
void add_jobs(CLI::App& app, std::string& value);
int parse_jobs(const std::string& text);
void add_fail_on_note(CLI::App& app, bool& value);

/// The options of PictureArguments, but for the file.
struct GivenPicture {
    std::string size{text_of(PictureArguments{}.size)}, samples{std::to_string(PictureArguments{}.samples)}, scale,
        ground{"scene"}, context{"auto"};

    void add_to(CLI::App& app, PictureArguments& arguments);
    void read_into(PictureArguments& arguments) const;
};

/// The options of Tolerance.
struct GivenTolerance {
    std::string channel{std::to_string(Tolerance{}.channel)}, share{text_of(Tolerance{}.share)};
    bool perceived = false;

    void add_to(CLI::App& app);
    Tolerance read() const;
    /// Whether any of them was given, of the command that they were added to.
    bool given(const CLI::App& app) const;
};

/// All that there is on a command line.
struct CommandLine {
    CommandLine();
    ~CommandLine();
    CommandLine(const CommandLine&) = delete;
    CommandLine& operator=(const CommandLine&) = delete;

private:
    std::unique_ptr<CLI::App> root_;

public:
    Declared view;  ///< the root itself: without a command
    std::vector<Declared> commands;
};

// The commands that make or judge many pictures; the others are declared where the command line is parsed.
Declared declare_sweep(CLI::App& root);
Declared declare_compare(CLI::App& root);
Declared declare_check(CLI::App& root);
// Those about lessons.
Declared declare_lessons(CLI::App& root);
Declared declare_handout(CLI::App& root);
Declared declare_slides(CLI::App& root);
Declared declare_quiz(CLI::App& root);
Declared declare_animate(CLI::App& root);

}  // namespace normalscope
