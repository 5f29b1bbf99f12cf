#include "core/mesh/mesh_file.h"

#include "core/base/beside.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/mesh/polygons.h"
#include "core/mesh/words.h"

#include <algorithm>
#include <array>
#include <set>
#include <system_error>

namespace normalscope {

namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;  // some 25 million triangles

template <Polygons (*read)(std::string_view, const std::string&)>
Mesh load_at_once(const std::filesystem::path& file) {
    const std::string bytes = read_file(file, kLargestFile), name = file.string();
    if (bytes.empty()) throw InputError(name + ": is empty; export the mesh anew");
    return mesh_of(read(bytes, name), name);
}

Mesh load_in_pieces(const std::filesystem::path& file) {
    return mesh_of(read_obj_file(file, kLargestFile), file.string());
}

void refuse_to_read_again(const std::filesystem::path& file) {
    if (!gives_once(file)) return;
    static OneAtATime one_at_a_time;
    static std::set<std::filesystem::path> read;
    one_at_a_time.run([&] {
        if (!read.insert(file).second)
            throw InputError(file.string(),
                             "is a pipe or device and can be read only once; save the mesh to a file first");
    });
}

struct Format {
    std::string_view ending;
    Mesh (*load)(const std::filesystem::path&);
};
constexpr std::array<Format, 3> kFormats{
    {{".obj", load_in_pieces}, {".ply", load_at_once<read_ply>}, {".stl", load_at_once<read_stl>}}};

const Format* format_of(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    const auto* const found =
        std::ranges::find_if(kFormats, [&](const Format& f) { return is_word(ending, f.ending); });
    return found == kFormats.end() ? nullptr : found;
}

}  // namespace

std::vector<std::string_view> mesh_endings() {
    std::vector<std::string_view> endings;
    for (const Format& format : kFormats) endings.push_back(format.ending);
    return endings;
}

std::string mesh_endings_in_words(std::string_view between, std::string_view before_last) {
    std::string words;
    for (const Format& format : kFormats)
        words.append(words.empty() ? "" : &format == &kFormats.back() ? before_last : between).append(format.ending);
    return words;
}

bool is_mesh_file(const std::filesystem::path& file) { return format_of(file) != nullptr; }

bool gives_once(const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::is_other(file, ignored);
}

Mesh load_mesh(const std::filesystem::path& file) {
    const Format* const format = format_of(file);
    if (!format)
        throw InputError(file.string() + ": its ending names no mesh format; a mesh ends in " +
                         mesh_endings_in_words(", ", " or "));
    refuse_to_read_again(file);
    return format->load(file);
}

}  // namespace normalscope
