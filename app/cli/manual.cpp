#include "cli/declare.h"
#include "cli/help.h"

#include <string_view>

namespace normalscope {

namespace {

// Text for troff: no character of it is a command.
std::string troff(std::string_view text) {
    std::string out;
    bool line_begins = true;
    for (const char c : text) {
        if (line_begins && (c == '.' || c == '\'')) out += "\\&";
        line_begins = c == '\n';
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if (c == '\'')
            out += "\\(aq";
        else
            out += c;
    }
    return out;
}

std::string option_heading(const CLI::Option& option) {
    if (option.get_positional()) return "\\fI" + troff(option.get_name(true)) + "\\fR";
    std::string heading;
    for (const std::string& name : option.get_snames()) heading += "\\fB\\-" + troff(name) + "\\fR, ";
    heading += "\\fB\\-\\-" + troff(option.get_lnames().front()) + "\\fR";
    return option.get_type_name().empty() ? heading : heading + " \\fI" + troff(option.get_type_name()) + "\\fR";
}

std::string options(const CLI::App& app) {
    std::string out;
    for (const CLI::Option* option : app.get_options()) {
        out += ".TP\n" + option_heading(*option) + "\n" + troff(option->get_description());
        if (!option->get_default_str().empty()) out += " [" + troff(option->get_default_str()) + "]";
        out += "\n";
    }
    return out;
}

std::string examples(const CLI::App& app) {
    std::string text = app.get_footer();
    text.erase(0, text.find('\n') + 1);
    return ".nf\n" + troff(text) + "\n.fi\n";
}

}  // namespace

std::string manual_page() {
    const CommandLine line;
    const CLI::App& root = *line.view.app;
    std::string page = ".TH NORMALSCOPE 1 \"\" \"" + version_text() +
                       "\" \"User commands\"\n.SH NAME\nnormalscope \\- " +
                       "shows what a transformation does to a surface\\(aqs normals\n.SH SYNOPSIS\n.nf\n" +
                       troff(usage_line(root)) + "\n";
    for (const Declared& command : line.commands) page += troff(usage_line(*command.app)) + "\n";
    page += ".fi\n.SH DESCRIPTION\n" + troff(root.get_description()) +
            " Without a command it opens a window.\n.SH OPTIONS\n" + options(root) + ".SH COMMANDS\n";
    for (const Declared& command : line.commands)
        page += ".SS " + troff(command.app->get_name()) + "\n" + troff(command.app->get_description()) + ".\n" +
                options(*command.app);
    page += ".SH EXIT STATUS\n";
    for (const auto& [code, meaning] : {std::pair{"0", "Done."},
                                        {"1", "The pictures differ, or a check fails."},
                                        {"2", "Wrong usage."},
                                        {"3", "A file cannot be read or written, or is not valid."},
                                        {"4", "There is nothing to draw with."}})
        page += ".TP\n\\fB" + std::string(code) + "\\fR\n" + meaning + "\n";
    page += ".SH EXAMPLES\n" + examples(root);
    for (const Declared& command : line.commands) page += examples(*command.app);
    return page;
}

}  // namespace normalscope
