#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace normalscope {

// What each operating system does in its own way: system_….cpp; where it keeps things, and what helps on it:
// conventions_….cpp, in which a Mac is not as other POSIX systems are. All text is UTF-8 on all of them, and a path made of
// text takes it so.

/// The first thing that `main` does: what the arguments are and what a terminal is told is UTF-8, and what goes through the
/// standard streams is left as it is.
void begin_process(int& argc, char**& argv);
int process_id();
/// Whether some process has this id now.
bool process_runs(int id);
/// Empty where nobody knows.
std::string host_name();

/// A variable of the environment. Empty where it is not set, or set to nothing.
std::string variable(const char* name);
/// Sets it for this process and those that it starts; nothing at all unsets it.
void set_variable(const char* name, const std::optional<std::string>& value);
/// The file of this very program; empty where nobody knows.
std::filesystem::path program_file();
/// The folder that a user calls home; empty where there is none.
std::filesystem::path home_folder();
/// The folder in which programs keep what they remember, this one's within it. Empty where there is none.
std::filesystem::path settings_folder_of(const char* program);
/// The same for what users have programs use.
std::filesystem::path data_folder_of(const char* program);

/// As std::fopen; errno says why there is none.
std::FILE* open_file(const std::filesystem::path& file, const char* mode);
/// The same, to write; EEXIST where there is one.
std::FILE* create_file(const std::filesystem::path& file);
/// Gives a file the name of another one, which it replaces at once. Throws std::system_error.
void replace_file(const std::filesystem::path& from, const std::filesystem::path& to);
/// What tells one file or folder from all others, whatever it is called. None where there is nothing.
std::optional<std::string> file_identity(const std::filesystem::path& file);
/// The same of the file that standard output goes to; empty where that is none.
std::string standard_output_identity();
bool is_terminal(std::FILE* stream);

/// What is written for a path. What is no text in it becomes U+FFFD.
std::string text_of(const std::filesystem::path& path);
/// The characters, beside those that control a terminal, which no file's name can have.
std::string_view never_in_names();
/// The places at which all paths begin, where there are several.
std::vector<std::filesystem::path> drives();
/// In small letters, of any alphabet: as a folder that takes any case has names.
std::string in_lower_case(const std::string& text);
/// The text as one word of the shell that is there: POSIX'; cmd and PowerShell on Windows.
std::string shell_word(const std::string& text);

/// A wish, which may go unheard: for many megabytes, to get one small page after the other takes longer than to read a file.
void prefer_large_pages(void* begin, std::size_t bytes);
/// The same for what is allocated from now on, until that is more than a picture and its samples take. What is freed stays with
/// the process, so this is for one that draws and ends.
void prefer_large_pages_from_now_on();

/// What may be missing, and how one comes by it: "install …".
enum class Missing { Osmesa, Egl, OpenGl, Ffmpeg };
const char* remedy(Missing what);

}  // namespace normalscope
