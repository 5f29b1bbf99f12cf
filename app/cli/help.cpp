#include "cli/help.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

constexpr std::size_t kWidth = 100;

std::string full_name(const CLI::App& app) {
    return app.get_parent() ? full_name(*app.get_parent()) + " " + app.get_name() : app.get_name();
}

struct Row {
    std::string name, text;
};

// Two columns under a heading, the second one wrapped.
void write_section(std::string& out, const std::string& heading, const std::vector<Row>& rows) {
    if (rows.empty()) return;
    std::size_t column = 0;
    for (const Row& row : rows) column = std::max(column, row.name.size() + 4);
    out += "\n" + heading + ":\n";
    for (const auto& [name, text] : rows) {
        std::string line = "  " + name + std::string(column - 2 - name.size(), ' ');
        bool empty = true;
        std::istringstream words(text);
        for (std::string word; words >> word; empty = false) {
            if (!empty && line.size() + 1 + word.size() > kWidth) {
                out += line + "\n";
                line = std::string(column, ' ');
                empty = true;
            }
            line += (empty ? "" : " ") + word;
        }
        out += line + "\n";
    }
}

// "-o, --output OUT.png"; options that have no short name leave its place free, so that the long ones align.
std::string option_name(const CLI::Option& option) {
    std::string name = option.get_snames().empty() ? "    " : "-" + option.get_snames().front() + ", ";
    name += "--" + option.get_lnames().front();
    return option.get_type_name().empty() ? name : name + " " + option.get_type_name();
}

std::string option_text(const CLI::Option& option) {
    const std::string& text = option.get_description();
    return option.get_default_str().empty() ? text : text + " [" + option.get_default_str() + "]";
}

}  // namespace

std::string usage_line(const CLI::App& app) {
    std::string line = full_name(app) + " [OPTIONS]";
    const auto named = [](const CLI::Option* o) { return !o->get_positional() && o->get_required(); };
    for (const CLI::Option* option : app.get_options(named)) {
        const std::string name =
            option->get_snames().empty() ? "--" + option->get_lnames().front() : "-" + option->get_snames().front();
        line += " " + name + " " + option->get_type_name();
    }
    for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_positional(); })) {
        const std::string name = option->get_name(true);
        line += option->get_required() ? " " + name : " [" + name + "]";
    }
    return line;
}

std::string help_text(const CLI::App& app) {
    std::string out = app.get_description() + "\n\nUsage: " + usage_line(app) + "\n";

    std::vector<Row> commands, arguments, options;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        commands.push_back({command->get_name(), command->get_description()});
    if (!commands.empty()) out += "       " + full_name(app) + " COMMAND --help\n";
    for (const CLI::Option* option : app.get_options()) {
        if (option->get_positional())
            arguments.push_back({option->get_name(true), option_text(*option)});
        else
            options.push_back({option_name(*option), option_text(*option)});
    }
    write_section(out, "Commands", commands);
    write_section(out, "Arguments", arguments);
    write_section(out, "Options", options);
    return app.get_footer().empty() ? out : out + "\n" + app.get_footer() + "\n";
}

}  // namespace normalscope
