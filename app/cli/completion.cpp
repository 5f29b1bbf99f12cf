#include "cli/declare.h"
#include "cli/help.h"
#include "core/base/text.h"
#include "core/lessons/tabs.h"

#include <initializer_list>
#include <string_view>
#include <utility>

namespace normalscope {

namespace {

/// What can stand in an option's value, by the word that its help has for it.
enum class Kind { Nothing, Anything, File, Folder, Words };
struct Values {
    Kind kind = Kind::Nothing;
    std::string words;
};

Values values_of(const CLI::Option& option) {
    const std::string word = option.get_type_name();
    if (word.empty()) return {};
    if (word == "FOLDER") return {Kind::Folder, ""};
    // A test holds these against what an unknown word is answered with.
    for (const auto& [name, words] :
         std::initializer_list<std::pair<const char*, std::string>>{{"context", "auto osmesa egl"},
                                                                    {"ground", "scene white transparent"},
                                                                    {"format", "text json latex"},
                                                                    {"tab", joined(tab_names(), " ")},
                                                                    {"samples", "1 2 4"}})
        if (option.check_lname(name)) return {Kind::Words, words};
    return {word.find("OUT") != std::string::npos || word.ends_with(".png") ? Kind::File : Kind::Anything, ""};
}

std::vector<const CLI::Option*> named_options(const CLI::App& app) {
    std::vector<const CLI::Option*> found;
    for (const CLI::Option* option : app.get_options())
        if (!option->get_positional()) found.push_back(option);
    return found;
}

std::string long_names(const CLI::App& app) {
    std::string names;
    for (const CLI::Option* option : named_options(app)) names += " --" + option->get_lnames().front();
    return names.substr(1);
}

std::string command_names(const CommandLine& line) {
    std::string names;
    for (const Declared& command : line.commands) names += " " + command.app->get_name();
    return names.substr(1);
}

// The shell command that lists the names which can stand in the place of a file; empty where none can.
std::string names_for(const CLI::App& app) {
    if (app.get_option_no_throw("FILE")) return "normalscope scenes 2>/dev/null; normalscope lessons 2>/dev/null";
    if (app.get_option_no_throw("LESSON")) return "normalscope lessons 2>/dev/null";
    return "";
}

// In single quotes, for fish.
std::string in_quotes(std::string_view text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') out += '\\';
        out += c;
    }
    return out + "'";
}

}  // namespace

std::string bash_completion() {
    const CommandLine line;
    std::string out =
        "# bash completion for normalscope, made from its options\n"
        "_normalscope_files() {  # a line each: their names may have spaces\n"
        "    local name\n    while IFS= read -r name; do COMPREPLY+=(\"$name\"); done < <(compgen \"$1\" -- "
        "\"$word\")\n}\n"
        "_normalscope() {\n"
        "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command= i\n"
        "    for ((i = 1; i < COMP_CWORD; ++i)); do\n        case ${COMP_WORDS[i]} in\n            ";
    std::string patterns = command_names(line);
    for (std::size_t at = 0; (at = patterns.find(' ', at)) != std::string::npos; at += 3)
        patterns.replace(at, 1, " | ");
    out += patterns +
           ") command=${COMP_WORDS[i]}; break ;;\n        esac\n    done\n    COMPREPLY=()\n"
           "    case $command/$before in\n";
    std::string option_lists, name_lists;
    const auto add = [&](const std::string& name, const CLI::App& app) {
        for (const CLI::Option* option : named_options(app)) {
            const Values values = values_of(*option);
            if (values.kind == Kind::Nothing) continue;
            std::string pattern = name + "/--" + option->get_lnames().front();
            for (const std::string& s : option->get_snames()) pattern += " | " + name + "/-" + s;
            out += "        " + pattern + ") ";
            if (values.kind == Kind::Words) out += "COMPREPLY=($(compgen -W \"" + values.words + "\" -- \"$word\")); ";
            if (values.kind == Kind::File) out += "_normalscope_files -f; ";
            if (values.kind == Kind::Folder) out += "_normalscope_files -d; ";
            out += "return ;;\n";
        }
        const std::string pattern = "        " + (name.empty() ? "''" : name) + ") ";
        option_lists += pattern + "options=\"" + long_names(app) + "\" ;;\n";
        if (const std::string names = names_for(app); !names.empty())
            name_lists += pattern + "names=$({ " + names + "; } | cut -d' ' -f1) ;;\n";
    };
    add("", *line.view.app);
    for (const Declared& command : line.commands) add(command.app->get_name(), *command.app);
    return out + "    esac\n    local options names=\n    case $command in\n" + option_lists +
           "    esac\n    if [[ $word == -* ]]; then\n        COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n    "
           "    return\n"
           "    fi\n    case $command in\n" +
           name_lists +
           "    esac\n"
           "    [[ -n $command ]] || names+=\" " +
           command_names(line) +
           "\"\n    COMPREPLY=($(compgen -W \"$names\" -- \"$word\"))\n    _normalscope_files -f\n}\n"
           "complete -o filenames -F _normalscope normalscope\n";
}

// zsh runs bash's function, which takes the place of this file's text when that is run for the first time.
std::string zsh_completion() {
    return "#compdef normalscope\nautoload -Uz bashcompinit && bashcompinit\n" + bash_completion() +
           "_bash_complete -o filenames -F _normalscope\n";
}

std::string fish_completion() {
    const CommandLine line;
    std::string out = "# fish completion for normalscope, made from its options\n";
    const auto add = [&](const std::string& condition, const CLI::App& app) {
        const std::string begin = "complete -c normalscope -n " + in_quotes(condition);
        if (const std::string names = names_for(app); !names.empty())
            out += begin + " -a \"(begin; " + names + "; end | string split -f1 ' ')\"\n";
        for (const CLI::Option* option : named_options(app)) {
            const Values values = values_of(*option);
            out += begin + " -l " + option->get_lnames().front();
            for (const std::string& s : option->get_snames()) out += " -s " + s;
            if (values.kind == Kind::Words) out += " -x -a " + in_quotes(values.words);
            if (values.kind == Kind::Folder) out += " -x -a '(__fish_complete_directories)'";
            if (values.kind == Kind::Anything) out += " -x";
            if (values.kind == Kind::File) out += " -r -F";
            out += " -d " + in_quotes(option->get_description()) + "\n";
        }
    };
    for (const Declared& command : line.commands)
        out += "complete -c normalscope -n __fish_use_subcommand -a " + command.app->get_name() + " -d " +
               in_quotes(command.app->get_description()) + "\n";
    add("__fish_use_subcommand", *line.view.app);
    for (const Declared& command : line.commands)
        add("__fish_seen_subcommand_from " + command.app->get_name(), *command.app);
    return out;
}

}  // namespace normalscope
